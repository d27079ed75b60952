#!/usr/bin/env python3
"""The same as hello.c in Python: ctypes and the shared library, no more.

Definitions are filled by the library and changed by path and text, so that a structure's layout
need not be written down twice: of each stands here what is used. skv_fill_def_init is told how much
that is, and the library takes the default for the rest.
SKVALP_LIBRARY names the library where the system does not find it.
"""
import ctypes
import os
import sys
from ctypes import (POINTER, byref, c_char, c_char_p, c_double, c_float, c_int, c_size_t, c_uint32,
                    c_uint64, c_void_p, sizeof)

library = ctypes.CDLL(os.environ.get("SKVALP_LIBRARY", "libskvalp.so.0"))


class Error(ctypes.Structure):
    _fields_ = [("code", c_int), ("text", c_char * 512)]


class WorldDef(ctypes.Structure):
    _fields_ = [("room", c_double * 128)]


class FillDef(ctypes.Structure):
    _fields_ = [("cookie", c_uint32), ("x0", c_float), ("y0", c_float), ("x1", c_float),
                ("y1", c_float)]


class Particles(ctypes.Structure):
    """Arrays of the world's own: nothing is copied."""
    _fields_ = [("count", c_int), ("x", POINTER(c_float)), ("y", POINTER(c_float)),
                ("room", c_double * 32)]


def declare(name, result, *arguments):
    function = getattr(library, name)
    function.restype, function.argtypes = result, arguments
    return function


version = declare("skv_version", c_char_p)
default_world_def = declare("skv_default_world_def", WorldDef)
fill_def_init = declare("skv_fill_def_init", None, c_void_p, c_size_t)
world_def_set = declare("skv_world_def_set", c_int, c_void_p, c_char_p, c_char_p, c_void_p)
world_create = declare("skv_world_create", c_int, c_void_p, POINTER(c_void_p), c_void_p)
world_destroy = declare("skv_world_destroy", None, c_void_p)
world_fill = declare("skv_world_fill", c_int, c_void_p, c_void_p, c_void_p, c_void_p)
world_step = declare("skv_world_step", c_int, c_void_p, c_float, c_void_p)
world_hash = declare("skv_world_hash", c_uint64, c_void_p)
world_particles = declare("skv_world_particles", Particles, c_void_p)


def check(function, *arguments):
    """Calls a function whose last argument is an error's place."""
    error = Error()
    if function(*arguments, byref(error)) != 0:
        sys.exit("hello: " + error.text.decode())


definition = default_world_def()
check(world_def_set, byref(definition), b"fluid.spacing", b"0.02")
world = c_void_p()
check(world_create, byref(definition), byref(world))
column = FillDef()
fill_def_init(byref(column), sizeof(column))
column.x1, column.y1 = 0.4, 0.6
check(world_fill, world, byref(column), None)
for frame in range(30):
    check(world_step, world, 1 / 60)

particles = world_particles(world)
centre = sum(particles.y[i] for i in range(particles.count)) / particles.count
print(f"skvalp {version().decode()}: {particles.count} particles, centre of mass at {centre:.3f} m, "
      f"hash {world_hash(world):016x}")
world_destroy(world)
