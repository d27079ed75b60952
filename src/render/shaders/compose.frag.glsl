#version 300 es
// Pass two: background, fluid where the splats' sum exceeds the threshold, walls on top.
precision highp float;
precision highp sampler2D;

// Sums over splats: pressure, trust in it, squared weight, weight.
uniform sampler2D u_splats;
uniform vec2 u_splat_size; // texels
uniform float u_texels;    // texels a view pixel
uniform float u_margin;    // texels around the view
uniform float u_gain;      // of the sums
uniform float u_crowd;     // how much larger the sums are than those of splats of the usual width
uniform vec2 u_threshold;  // of weight: for a lone particle, and for the edge of a body of fluid
uniform float u_reach;     // radius of a splat, view pixels

uniform sampler2D u_walls; // distance to the nearest wall, m
uniform float u_scale;     // view pixels a metre
uniform vec2 u_origin;     // view pixel of the world's origin, y up
uniform vec2 u_world;      // m
uniform vec4 u_closed;     // left, right, bottom, top: 1 if the side is solid
uniform vec2 u_view;       // pixels

uniform vec3 u_sky;
uniform vec3 u_ground;
uniform vec3 u_shade; // of walls on the background
uniform vec3 u_wall;
uniform vec3 u_wall_edge;
uniform vec3 u_shallow;
uniform vec3 u_middle;
uniform vec3 u_deep;
uniform vec3 u_surface;
uniform float u_pixel; // view pixels a line of the drawing is wide

out vec4 o_color;

// How far the sums exceed the threshold: 1 on the fluid's outline. The threshold rises with the
// number of particles that contribute, (sum w)^2 / sum w^2, so that a lone particle is drawn as a
// drop of its own area and a body of fluid ends where its particles' areas do.
float excess(vec4 sums, float lift)
{
    float weight = sums.a * lift / u_gain;
    float number = weight * weight / max(sums.b * lift / u_gain, 1.0e-6);
    float share = clamp(0.5 * (number - 1.0), 0.0, 1.0);
    return weight / (u_crowd * mix(u_threshold.x, u_threshold.y, share));
}

// Metres to the nearest wall, also outside the picture, where closed sides are solid.
float wall_distance(vec2 point)
{
    float d = textureLod(u_walls, point / u_world, 0.0).r;
    vec4 sides = vec4(point, u_world - point).xzyw;
    vec4 inside = mix(vec4(1.0e3), sides, u_closed);
    return min(d, min(min(inside.x, inside.y), min(inside.z, inside.w)));
}

// The share of a splat that lies on the free side of a straight wall at this distance: the integral
// of (1 - t^2)^3.5. Fluid at a wall lacks the splats that would lie behind it; divided by this
// share, their sum meets the wall squarely.
float free_share(float wall)
{
    float t = clamp(wall / u_reach, 0.0, 1.0);
    float t2 = t * t;
    return 0.5 + t * (1.164 + t2 * (-1.358 + t2 * (0.974 - 0.28 * t2)));
}

// A pattern of less than one grey step that keeps the gradients free of bands.
float dither(vec2 pixel)
{
    return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

vec3 fluid_color(float pressure)
{
    float p = clamp(pressure, 0.0, 1.0);
    return p < 0.5 ? mix(u_shallow, u_middle, p * 2.0) : mix(u_middle, u_deep, p * 2.0 - 1.0);
}

void main()
{
    vec2 pixel = gl_FragCoord.xy;
    float wall = wall_distance((pixel - u_origin) / u_scale) * u_scale; // view pixels
    vec4 sums = textureLod(u_splats, (pixel * u_texels + u_margin) / u_splat_size, 0.0);
    float lift = 1.0 / free_share(wall);
    float fluid = excess(sums, lift);
    float slope = max(fwidth(fluid), 0.02);

    // Background, a little darker along walls.
    vec3 color = mix(u_ground, u_sky, pixel.y / u_view.y);
    color = mix(color, u_shade, 0.5 * exp2(-max(wall, 0.0) / (9.0 * u_pixel)));

    if (wall > -2.0 && fluid > 0.5) {
        float depth = (fluid - 1.0) / slope; // pixels below the surface, near it
        float rim = 1.0 - smoothstep(0.5 * u_pixel, 2.5 * u_pixel, depth);
        vec3 water = mix(fluid_color(sums.r / max(sums.g, 1.0e-5)), u_surface, 0.55 * rim);
        color = mix(color, water, smoothstep(-0.5, 0.5, depth));
    }

    vec3 solid = mix(u_wall_edge, u_wall, smoothstep(0.5 * u_pixel, 2.5 * u_pixel, -wall));
    color = mix(color, solid, clamp(0.5 - wall, 0.0, 1.0));
    o_color = vec4(color + dither(pixel), 1.0);
}
