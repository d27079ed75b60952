/* Compose: one triangle over the view, and all that its shader has to know. There is a program for
 * each kind of picture, because a processor that draws works through every branch of a shader,
 * taken or not. Invariant: every uniform of the program is set by every call. */
#include "render/compose.h"

#include <math.h>

#include "render/shaders.h"

/* The program for a kind of picture, made when it is first needed. */
static skv_result find_program(skv_compose *compose, skv_shown shown, bool full, GLuint *program,
                               skv_error *error)
{
    static const char *const defines[SKV_SHOWN_KINDS][2] = {
        [SKV_SHOWN_NO_FLUID] = {"", "#define FULL\n"},
        [SKV_SHOWN_WATER] = {"#define WATER\n", "#define WATER\n#define FULL\n"},
        [SKV_SHOWN_TINTED] = {"#define WATER\n#define TINTED\n",
                              "#define WATER\n#define TINTED\n#define FULL\n"},
        [SKV_SHOWN_PARTED] = {"#define WATER\n#define PARTED\n",
                              "#define WATER\n#define PARTED\n#define FULL\n"},
        [SKV_SHOWN_PARTED_TINTED] = {"#define WATER\n#define PARTED\n#define TINTED\n",
                                     "#define WATER\n#define PARTED\n#define TINTED\n"
                                     "#define FULL\n"},
        [SKV_SHOWN_VALUE] = {"#define SCALE\n", "#define SCALE\n#define FULL\n"}};
    GLuint *made = &compose->programs[shown][full];
    skv_result result = SKV_OK;
    if (!*made)
        result = skv_gl_program("compose", defines[shown][full], skv_shader_compose_vert,
                                skv_shader_compose_frag, made, error);
    *program = *made;
    return result;
}

skv_result skv_compose_create(skv_compose *compose, skv_error *error)
{
    *compose = (skv_compose){0};
    glGenVertexArrays(1, &compose->attributes);
    compose->scale = skv_gl_texture();
    /* A device that cannot compile these says so now. */
    GLuint program;
    skv_result result = find_program(compose, SKV_SHOWN_WATER, false, &program, error);
    return result == SKV_OK ? find_program(compose, SKV_SHOWN_WATER, true, &program, error)
                            : result;
}

void skv_compose_destroy(skv_compose *compose)
{
    for (int shown = 0; shown < SKV_SHOWN_KINDS; shown++)
        for (int full = 0; full < 2; full++)
            glDeleteProgram(compose->programs[shown][full]);
    glDeleteVertexArrays(1, &compose->attributes);
    glDeleteTextures(1, &compose->scale);
    *compose = (skv_compose){0};
}

static void set1(GLuint program, const char *name, double value)
{
    glUniform1f(glGetUniformLocation(program, name), (float)value);
}

static void set2(GLuint program, const char *name, double x, double y)
{
    glUniform2f(glGetUniformLocation(program, name), (float)x, (float)y);
}

static void set_colors(GLuint program, const skv_colors *colors)
{
    const struct {
        const char *name;
        const float *color;
    } all[] = {{"u_sky", colors->sky},         {"u_ground", colors->ground},
               {"u_shade", colors->shade},     {"u_wall", colors->wall},
               {"u_deep", colors->deep},       {"u_wall_edge", colors->wall_edge},
               {"u_shallow", colors->shallow}, {"u_surface", colors->surface},
               {"u_light", colors->light},     {"u_outline", colors->outline},
               {"u_murk", colors->murk}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        glUniform3fv(glGetUniformLocation(program, all[i].name), 1, all[i].color);
    set1(program, "u_tint_light", (double)SKV_TINT_LIGHT);
    set1(program, "u_relief", (double)colors->relief);
    set1(program, "u_foam", (double)colors->foam);
}

static void set_geometry(GLuint program, const skv_frame *frame, const skv_camera *camera)
{
    const skv_terrain *terrain = frame->terrain;
    unsigned open = skv_terrain_open_sides(terrain);
    set1(program, "u_scale", camera->scale);
    set2(program, "u_origin", camera->origin_x, camera->height - camera->origin_y);
    set2(program, "u_world", (double)skv_terrain_width(terrain),
         (double)skv_terrain_height(terrain));
    glUniform4f(glGetUniformLocation(program, "u_closed"), open & SKV_SIDE_LEFT ? 0 : 1,
                open & SKV_SIDE_RIGHT ? 0 : 1, open & SKV_SIDE_BOTTOM ? 0 : 1,
                open & SKV_SIDE_TOP ? 0 : 1);
    set2(program, "u_view", camera->width, camera->height);
    set1(program, "u_pixel", skv_look_line(camera));
    set1(program, "u_spacing", (double)frame->spacing * camera->scale);
}

/* What a splat loses at a lone drop's outline where texels are interpolated: 4.5 times the variance
 * of that in units of the radius, which is 1/3 of a texel for a cubic B-spline and half of it
 * linearly. */
static double lost_peak(const skv_splats *splats, bool full)
{
    double radius = splats->reach * splats->target.texels;
    return (full ? 1.5 : 0.75) / (radius * radius);
}

static void set_splats(GLuint program, const skv_splats *splats, const skv_composition *picture)
{
    set2(program, "u_splat_size", splats->target.width, splats->target.height);
    set1(program, "u_texels", splats->target.texels);
    set1(program, "u_margin", splats->target.margin);
    set1(program, "u_gain", splats->gain);
    set2(program, "u_code", splats->code[0], splats->code[1]);
    set1(program, "u_crowd", splats->crowd);
    set2(program, "u_threshold", SKV_THRESHOLD_LONE - lost_peak(splats, picture->full),
         SKV_THRESHOLD_BODY);
    double known = SKV_TERRAIN_REACH * (double)skv_terrain_pixel_size(picture->frame->terrain);
    set1(program, "u_reach", fmin(splats->reach, 0.98 * known * picture->camera->scale));
    glUniform1i(glGetUniformLocation(program, "u_foamy"), splats->foamy);
}

static void bind(GLuint program, const char *name, int unit, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glUniform1i(glGetUniformLocation(program, name), unit);
}

/* What the values mean, and their colours. */
static void set_scale(const skv_compose *compose, GLuint program, const skv_composition *picture)
{
    const skv_legend *legend = picture->legend;
    const double *slope = picture->slope;
    bool lines = picture->view == SKV_VIEW_PRESSURE;
    glUniform3f(glGetUniformLocation(program, "u_slope"), (float)slope[0], (float)slope[1],
                (float)slope[2]);
    set1(program, "u_lines", lines ? legend->high / legend->step : 0);
    bind(program, "u_map", 3, compose->scale);
    if (legend->shown)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, SKV_LEGEND_COLORS, 1, 0, GL_RGB, GL_UNSIGNED_BYTE,
                     legend->colors);
}

/* A first fluid that is no water has its own colour in the light of each depth, as the shader's
 * light_at has it for the others. */
static void set_first(GLuint program, const skv_colors *colors, const float color[3])
{
    static const char *const names[] = {"u_murk", "u_deep", "u_shallow"};
    const float light[] = {0, 1 - 0.16f * colors->relief, 1 + 0.1f * colors->relief};
    for (int i = 0; i < 3; i++)
        glUniform3f(glGetUniformLocation(program, names[i]), i ? light[i] * color[0] : 1,
                    i ? light[i] * color[1] : 1, i ? light[i] * color[2] : 1);
}

static void set_fluids(GLuint program, const skv_splats *splats, const skv_composition *picture)
{
    float fluids[SKV_MAX_FLUIDS][3];
    for (int i = 1; i < SKV_MAX_FLUIDS; i++)
        skv_look_fluid(picture->colors, picture->frame, i, fluids[i]);
    if (skv_look_fluid(picture->colors, picture->frame, 0, fluids[0]))
        set_first(program, picture->colors, fluids[0]);
    glUniform3fv(glGetUniformLocation(program, "u_fluids"), SKV_MAX_FLUIDS, fluids[0]);
    glUniform1i(glGetUniformLocation(program, "u_last"), splats->last_fluid);
}

static skv_shown choose_shown(const skv_composition *picture, const bool used[SKV_SPLATS])
{
    if (picture->view == SKV_VIEW_PARTICLES)
        return SKV_SHOWN_NO_FLUID;
    if (picture->legend->shown)
        return SKV_SHOWN_VALUE;
    bool tinted = used[SKV_SPLAT_TINTS];
    if (used[SKV_SPLAT_FEW])
        return tinted ? SKV_SHOWN_PARTED_TINTED : SKV_SHOWN_PARTED;
    return tinted ? SKV_SHOWN_TINTED : SKV_SHOWN_WATER;
}

skv_result skv_compose_draw(skv_compose *compose, const skv_splats *splats, const skv_walls *walls,
                            const skv_composition *picture, skv_error *error)
{
    GLuint program;
    skv_result result =
        find_program(compose, choose_shown(picture, splats->used), picture->full, &program, error);
    if (result != SKV_OK)
        return result;
    glUseProgram(program);
    set_colors(program, picture->colors);
    set_geometry(program, picture->frame, picture->camera);
    set_splats(program, splats, picture);
    set_scale(compose, program, picture);
    bind(program, "u_walls", 2, walls->texture);
    set_fluids(program, splats, picture);
    bind(program, "u_more", 5, splats->textures[SKV_SPLAT_MORE]);
    bind(program, "u_few", 4, splats->textures[SKV_SPLAT_FEW]);
    bind(program, "u_tints", 1, splats->textures[SKV_SPLAT_TINTS]);
    bind(program, "u_splats", 0, splats->textures[SKV_SPLAT_SUMS]);
    glBindVertexArray(compose->attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    return SKV_OK;
}
