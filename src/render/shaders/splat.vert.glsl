// Pass one: a particle becomes a point sprite in the splat buffer.

uniform vec2 u_scale;     // clip units a metre
uniform vec2 u_offset;    // clip position of the world's origin
uniform float u_diameter; // of a splat, texels

layout(location = 0) in vec2 a_position; // m
layout(location = 1) in vec2 a_value;    // what the view shows, times trust; trust in it, or foam
layout(location = 2) in vec4 a_tint;     // what its dye takes of light, and how much
layout(location = 3) in float a_fluid;   // its number

out vec2 v_value;
out vec4 v_tint;
flat out float v_fluid;

void main()
{
    gl_Position = vec4(a_position * u_scale + u_offset, 0.0, 1.0);
    gl_PointSize = u_diameter;
    v_value = a_value;
    v_tint = a_tint;
    v_fluid = a_fluid;
}
