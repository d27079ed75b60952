// Pass one: adds a soft round spot, 1 in the centre and 0 at the edge, and what the particle shows
// with it.

uniform float u_gain; // below 1 where the buffer cannot hold sums above 1
uniform vec2 u_code;  // factor and offset that bring values into what the buffer holds

in vec2 v_value;
in vec4 v_tint;
flat in float v_fluid;

layout(location = 0) out vec4 o_sums;
layout(location = 1) out vec4 o_tint;
layout(location = 2) out vec4 o_few;  // shares of fluids 1 to 3, and of all
layout(location = 3) out vec4 o_more; // of 4 to 7

void main()
{
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float rest = max(1.0 - dot(p, p), 0.0);
    float weight = rest * rest * rest;
    o_sums = weight * u_gain *
             vec4(v_value.x * u_code.x + v_value.y * u_code.y, v_value.y, weight, 1.0);
    o_tint = weight * u_gain * v_tint;
    // Narrower, so that fluids part where they do, and a drop of one particle shows.
    float share = weight * weight * weight * u_gain;
    o_few = share * vec4(equal(vec4(v_fluid), vec4(1.0, 2.0, 3.0, v_fluid)));
    o_more = share * vec4(equal(vec4(v_fluid), vec4(4.0, 5.0, 6.0, 7.0)));
}
