// A stroke: one quad an instance, along the line.

uniform vec2 u_view; // pixels

layout(location = 0) in vec4 a_ends;   // view pixels
layout(location = 1) in vec3 a_shape;  // radius, width of a ring's line, length of a dash; pixels
layout(location = 2) in vec4 a_color;

out vec2 v_point;       // pixels from the middle of the line, along and across
flat out float v_half;  // half the line's length
flat out vec3 v_shape;
flat out vec4 v_color;

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec2 way = a_ends.zw - a_ends.xy;
    float way_length = length(way);
    vec2 along = way_length > 1.0e-3 ? way / way_length : vec2(1.0, 0.0);
    v_half = 0.5 * way_length;
    v_shape = a_shape;
    v_color = a_color;
    v_point = corner * (a_shape.x + 1.0 + vec2(v_half, 0.0));
    vec2 pixel = 0.5 * (a_ends.xy + a_ends.zw) + v_point.x * along +
                 v_point.y * vec2(-along.y, along.x);
    gl_Position = vec4(2.0 * pixel / u_view - 1.0, 0.0, 1.0);
}
