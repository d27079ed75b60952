/* The texts of the files in shaders/; see embed.cmake. */
#ifndef SKV_RENDER_SHADERS_H
#define SKV_RENDER_SHADERS_H

extern const char skv_shader_common[];
extern const char skv_shader_splat_vert[];
extern const char skv_shader_splat_frag[];
extern const char skv_shader_compose_vert[];
extern const char skv_shader_compose_frag[];
extern const char skv_shader_stroke_vert[];
extern const char skv_shader_stroke_frag[];

#endif
