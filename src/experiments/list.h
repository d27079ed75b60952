/* The experiments in the order in which they are presented. NAME stands for skv_exp_NAME, which a
 * file exp_NAME.c defines: whoever adds one writes that file and a line here. */
#define SKV_EXPERIMENTS(X)                                                                         \
    X(hydrostatics)                                                                                \
    X(layers)                                                                                      \
    X(rest)                                                                                        \
    X(u_tube)                                                                                      \
    X(vessels)                                                                                     \
    X(slosh)                                                                                       \
    X(wave_train)                                                                                  \
    X(dam_break)                                                                                   \
    X(conjugate_depths)                                                                            \
    X(orifice)                                                                                     \
    X(torricelli)                                                                                  \
    X(channel)                                                                                     \
    X(archimedes)                                                                                  \
    X(float)                                                                                       \
    X(bell)                                                                                        \
    X(momentum)                                                                                    \
    X(droplet)                                                                                     \
    X(ringing)                                                                                     \
    X(viscosity)                                                                                   \
    X(sag)                                                                                         \
    X(rayleigh_taylor)
