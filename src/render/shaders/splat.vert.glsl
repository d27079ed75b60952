#version 300 es
// Pass one: a particle becomes a point sprite in the splat buffer.
precision highp float;

uniform vec2 u_scale;    // clip units a metre
uniform vec2 u_offset;   // clip position of the world's origin
uniform float u_diameter; // of a splat, texels

layout(location = 0) in vec2 a_position;  // m
layout(location = 1) in vec2 a_pressure; // share of the pressure shown as white, trust in it

out vec2 v_pressure;

void main()
{
    gl_Position = vec4(a_position * u_scale + u_offset, 0.0, 1.0);
    gl_PointSize = u_diameter;
    v_pressure = a_pressure;
}
