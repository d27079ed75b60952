#version 300 es
// Pass one: adds a soft round spot, 1 in the centre and 0 at the edge, and the pressure with it.
precision highp float;

uniform float u_gain; // below 1 where the buffer cannot hold sums above 1

in vec2 v_pressure;

out vec4 o_sums;

void main()
{
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float rest = max(1.0 - dot(p, p), 0.0);
    float weight = rest * rest * rest;
    float trusted = weight * v_pressure.y;
    o_sums = vec4(trusted * v_pressure.x, trusted, weight * weight, weight) * u_gain;
}
