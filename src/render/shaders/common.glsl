// Before every shader: precision, and what several of them know about walls.
precision highp float;
precision highp sampler2D;

uniform sampler2D u_walls; // distance to the nearest wall, m
uniform vec2 u_world;      // m
uniform vec4 u_closed;     // left, right, bottom, top: 1 if the side is solid

// Metres to the nearest wall, also outside the picture, where closed sides are solid.
float wall_distance(vec2 point)
{
    float d = textureLod(u_walls, point / u_world, 0.0).r;
    vec4 sides = vec4(point, u_world - point).xzyw;
    vec4 inside = mix(vec4(1.0e3), sides, u_closed);
    return min(d, min(min(inside.x, inside.y), min(inside.z, inside.w)));
}
