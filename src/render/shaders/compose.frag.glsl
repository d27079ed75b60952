// Pass two: background, fluid where the splats' sum exceeds the threshold, walls on top. The fluid
// is water by its depth if WATER is defined, with other fluids beside it if PARTED is and dyes in them
// if TINTED is, a value on a scale if SCALE is, else it is left out. With FULL defined, light and smoothness that software drawing cannot
// afford.

// Sums over splats: value, trust in it or foam, squared weight, weight; what dyes take; shares of
// fluids 1 to 3, and of all; and of 4 to 7.
uniform sampler2D u_splats;
uniform sampler2D u_tints;
uniform sampler2D u_few;
uniform sampler2D u_more;
uniform int u_last;        // the highest number of them
uniform vec3 u_fluids[8];  // their colours
uniform bool u_foamy;      // foam it is
uniform vec2 u_splat_size; // texels
uniform float u_texels;    // texels a view pixel
uniform float u_margin;    // texels around the view
uniform float u_gain;      // of the sums
uniform vec2 u_code;       // factor and offset of the values
uniform float u_crowd;     // how much larger the sums are than those of splats of the usual width
uniform vec2 u_threshold;  // of weight: for a lone particle, and for the edge of a body of fluid
uniform float u_reach;     // radius of a splat, view pixels; at most as far as walls are known
uniform float u_spacing;   // view pixels

uniform float u_scale; // view pixels a metre
uniform vec2 u_origin; // view pixel of the world's origin, y up
uniform vec2 u_view;   // pixels
uniform float u_pixel; // view pixels a line of the drawing is wide

uniform vec3 u_slope;     // of the value per metre to the right and up, and at the origin
uniform float u_lines;    // isolines a unit of the value; 0: none
uniform sampler2D u_map;  // the scale's colours

uniform vec3 u_sky;
uniform vec3 u_ground;
uniform vec3 u_shade; // of walls on the background
uniform vec3 u_wall;
uniform vec3 u_wall_edge;
uniform vec3 u_shallow;
uniform vec3 u_deep;
uniform vec3 u_surface; // the line along the outline
uniform vec3 u_light;   // what the rim and the foam shine with
uniform vec3 u_outline; // the outline of fluid that shows a scale
uniform float u_relief; // how much light models the fluid, 0..1
uniform float u_foam;   // how much foam covers it, 0..1
uniform vec3 u_murk;    // how fast light fades, by colour
uniform float u_tint_light; // the most that a tint takes, in powers of e

out vec4 o_color;

#if defined(WATER) || defined(SCALE)
#define FLUID
#endif

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

// The share of a splat that lies on the free side of a straight wall at this distance: the integral
// of (1 - t^2)^3.5. Fluid at a wall lacks the splats that would lie behind it; divided by this
// share, their sum meets the wall squarely.
float free_share(float wall)
{
    float t = clamp(wall / u_reach, 0.0, 1.0);
    float t2 = t * t;
    return 0.5 + t * (1.164 + t2 * (-1.358 + t2 * (0.974 - 0.28 * t2)));
}

#ifdef FULL
// Where four linear taps make a cubic B-spline of sixteen texels: the outline has no corners.
struct Taps {
    vec2 a, b;
    vec2 weight; // of b
};

Taps taps_at(vec2 texel)
{
    vec2 p = texel - 0.5, i = floor(p), f = p - i;
    vec2 f2 = f * f, f3 = f2 * f;
    vec2 w0 = (1.0 - 3.0 * f + 3.0 * f2 - f3) / 6.0, w3 = f3 / 6.0;
    vec2 w1 = (4.0 - 6.0 * f2 + 3.0 * f3) / 6.0, w2 = 1.0 - w0 - w1 - w3;
    return Taps((i + w1 / (w0 + w1) - 0.5) / u_splat_size,
                (i + w3 / (w2 + w3) + 1.5) / u_splat_size, w2 + w3);
}

vec4 sample_at(sampler2D image, Taps taps)
{
    vec4 below = mix(textureLod(image, taps.a, 0.0),
                     textureLod(image, vec2(taps.b.x, taps.a.y), 0.0), taps.weight.x);
    vec4 above = mix(textureLod(image, vec2(taps.a.x, taps.b.y), 0.0),
                     textureLod(image, taps.b, 0.0), taps.weight.x);
    return mix(below, above, taps.weight.y);
}
#else
#define Taps vec2
vec2 taps_at(vec2 texel)
{
    return texel / u_splat_size;
}

vec4 sample_at(sampler2D image, vec2 place)
{
    return textureLod(image, place, 0.0);
}
#endif

// A pattern of less than one grey step that keeps the gradients free of bands.
float dither(vec2 pixel)
{
    return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

// The middle of the pixels about a whole number of `line`, 1 there and 0 elsewhere. Not about 0: that
// is the outline, and in what flies, whose pressure is 0 everywhere, rounding would say where it lies.
float isoline(float line, float width)
{
    float a_pixel = max(fwidth(line), 1.0e-5);
    float from_line = abs(fract(line - 0.5) - 0.5) / a_pixel; // pixels
    float crowded = 1.0 - smoothstep(0.08, 0.25, a_pixel);    // too many to tell apart
    return step(0.5, abs(line)) * crowded *
           (1.0 - smoothstep(0.5 * width - 0.5, 0.5 * width + 0.5, from_line));
}

#ifdef FULL
// Water with light from above: `inside` goes from 0 at the outline to 1 where the surface lies flat.
vec3 lit(vec3 water, vec2 outwards, float inside, float rim, float foam)
{
    float tilt = 1.0 - inside;
    vec3 normal = vec3(outwards * tilt, sqrt(max(1.0 - tilt * tilt, 0.0)));
    float up = dot(normal, vec3(-0.30, 0.86, 0.41)) - 0.41;
    float shine = pow(max(dot(normal, vec3(-0.24, 0.66, 0.71)), 0.0), 24.0);
    vec3 color = water * (1.0 + u_relief * 0.24 * tilt * min(up, 0.0));
    color = mix(color, u_light, u_relief * tilt * (0.75 * max(up, 0.0) + 0.35 * shine));
    color = mix(color, u_light, u_foam * foam);
    return mix(color, u_surface, rim * mix(0.45, 0.95, smoothstep(-0.4, 0.5, outwards.y)));
}
#endif

#if defined(TINTED) || defined(PARTED)
// What is left of the light that a colour was chosen in.
float light_at(float depth)
{
    return 1.0 + u_relief * (0.26 * exp(-depth) - 0.16);
}
#endif

#ifdef TINTED
// Fluid with dyes in it, each of which takes its part of the light: colours multiply, as inks do.
// `tint` is the light that they take, and how much of the fluid they are.
vec3 tinted(vec3 fluid, vec4 tint, float depth)
{
    return exp(max(1.0 - tint.a, 0.0) * log(fluid) + tint.a * log(light_at(depth)) - u_tint_light * tint.rgb);
}
#endif

#ifdef PARTED
// The two fluids that have most of a place, and their colours.
struct Two {
    float most, next;
    vec3 here, there;
};

void consider(inout Two two, float share, vec3 color)
{
    bool leads = share > two.most, follows = share > two.next;
    two.there = leads ? two.here : follows ? color : two.there;
    two.next = leads ? two.most : follows ? share : two.next;
    two.here = leads ? color : two.here;
    two.most = leads ? share : two.most;
}

// The fluid that has most of a place. Where the next has about as much, within a pixel, the line
// between both is smooth; no third colour comes of it.
vec3 parted(vec3 water, Taps taps, float depth)
{
    vec4 few = sample_at(u_few, taps), more = vec4(0.0);
    if (u_last > 3)
        more = sample_at(u_more, taps);
    float rest = few.a - dot(few.rgb, vec3(1.0)) - dot(more, vec4(1.0));
    float light = light_at(depth);
    Two two = Two(rest, few.r, water, light * u_fluids[1]);
    if (few.r > rest)
        two = Two(few.r, rest, two.there, water);
    if (u_last > 1) {
        consider(two, few.g, light * u_fluids[2]);
        consider(two, few.b, light * u_fluids[3]);
    }
    if (u_last > 3) {
        consider(two, more.r, light * u_fluids[4]);
        consider(two, more.g, light * u_fluids[5]);
        consider(two, more.b, light * u_fluids[6]);
        consider(two, more.a, light * u_fluids[7]);
    }
    // Across a straight line the lead grows by 1.5 a spacing, 0.3 of a splat's radius.
    float lead = 0.3 * u_reach / u_pixel * (two.most - two.next) / max(few.a, 1.0e-5 * u_gain);
    return mix(two.there, two.here, 0.5 + 0.5 * min(lead, 1.0));
}
#endif

#ifdef FLUID
// What the fluid's pixels look like, and how far it covers them, in w. `wall` is in view pixels, as
// `point` is in metres.
vec4 fluid_at(vec2 pixel, vec2 point, float wall)
{
    vec2 texel = pixel * u_texels + u_margin;
    Taps taps = taps_at(texel);
    vec4 sums = sample_at(u_splats, taps);
    float fluid = excess(sums, 1.0 / free_share(wall));
    vec2 rise = vec2(dFdx(fluid), dFdy(fluid));
    float slope = max(length(rise), 0.004);
    float depth = (fluid - 1.0) / slope; // pixels below the outline, near it
    float body = smoothstep(1.5, 1.9, fluid); // where a slope has nothing to do with the outline
    // Nor has one towards a wall that fluid touches: in a corner two walls take from the sum. On its
    // bisector the slopes are of one wall along x and of the other along y, so there the outline is
    // looked for where the splats alone grow fewer.
    vec2 steep = vec2(dFdx(wall), dFdy(wall)), fewer = vec2(dFdx(sums.a), dFdy(sums.a));
    bool turns = wall < u_spacing && abs(dot(steep, steep) - 1.0) > 0.5;
    vec2 from = turns ? fewer / max(length(fewer), 1.0e-6) : rise / slope;
    vec2 ahead = -from * 0.7 * u_spacing; // view pixels
#ifdef FULL
    float wall_ahead = wall_distance(point + ahead / u_scale) * u_scale;
#else
    float wall_ahead = wall + dot(steep, ahead); // if it is straight
    if (turns)
        wall_ahead = wall_distance(point + ahead / u_scale) * u_scale;
#endif
    body = max(body, 1.0 - smoothstep(-0.3, 0.0, wall_ahead / u_spacing));
    float rim = (1.0 - body) * (1.0 - smoothstep(0.4 * u_pixel, 2.0 * u_pixel, depth));

    float value = (sums.r / max(u_foamy ? sums.a : sums.g, 1.0e-5) - u_code.y) / u_code.x;
    value += dot(u_slope, vec3(point, 1.0));
#ifdef SCALE
    float line = u_lines > 0.0 ? isoline(value * u_lines, 1.3 * u_pixel) : 0.0;
#endif
    if (wall <= -2.0 || fluid <= 0.3)
        return vec4(0.0);
#ifdef WATER
    vec3 water = mix(u_deep, u_shallow, exp(-max(value, 0.0) * u_murk));
    float weight = max(sums.a, 1.0e-5 * u_gain);
#ifdef PARTED
    water = parted(water, taps, max(value, 0.0));
#endif
#ifdef TINTED
    water = tinted(water, sample_at(u_tints, taps) / weight, max(value, 0.0));
#endif
#ifdef FULL
    float foam = u_foamy ? clamp(sums.g / weight, 0.0, 1.0) : 0.0;
    float inside = clamp(depth / min(1.1 * u_spacing, 18.0 * u_pixel), body, 1.0);
    water = lit(water, -rise / slope, inside, rim, foam);
#else
    water = mix(water, u_surface, 0.7 * rim);
#endif
#else
    float place = clamp(value, 0.0, 1.0);
    vec3 water = textureLod(u_map, vec2((place * 63.0 + 0.5) / 64.0, 0.5), 0.0).rgb;
    water = mix(water, u_outline, max(0.5 * line, rim));
#endif
    return vec4(water, smoothstep(-0.5, 0.5, depth));
}
#endif

void main()
{
    vec2 pixel = gl_FragCoord.xy;
    vec2 point = (pixel - u_origin) / u_scale;
    float wall = wall_distance(point) * u_scale; // view pixels

    // Background, a little darker along walls.
    vec3 color = mix(u_ground, u_sky, pixel.y / u_view.y);
    color = mix(color, u_shade, 0.5 * exp2(-max(wall, 0.0) / (9.0 * u_pixel)));
#ifdef FLUID
    vec4 fluid = fluid_at(pixel, point, wall);
    color = mix(color, fluid.rgb, fluid.a);
#endif

    vec3 solid = u_wall;
#ifdef FULL
    // A bevel, lit from above.
    vec2 facing = vec2(dFdx(wall), dFdy(wall));
    facing /= max(length(facing), 1.0e-4);
    float bevel = 1.0 - smoothstep(0.0, 7.0 * u_pixel, -wall);
    solid *= 1.0 + 0.16 * u_relief * bevel * dot(facing, vec2(-0.3, 0.95));
#endif
    solid = mix(u_wall_edge, solid, smoothstep(0.5 * u_pixel, 2.0 * u_pixel, -wall));
    color = mix(color, solid, clamp(0.5 - wall, 0.0, 1.0));
    o_color = vec4(color + dither(pixel), 1.0);
}
