/* The border between a WebAssembly module and its host, the page or program that runs it. */
#ifndef SKV_BASE_WASM_HOST_H
#define SKV_BASE_WASM_HOST_H

/* Declares a function of the host's: import "host" "name". The host answers at once. */
#define SKV_HOST(name) __attribute__((import_module("host"), import_name(#name)))

/* Defines a function that the host calls, besides the public ones (SKV_API). */
#define SKV_EXPORT(name) __attribute__((export_name(#name)))

#endif
