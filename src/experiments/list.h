/* The experiments in the order in which they are presented. NAME stands for skv_exp_NAME, which a
 * file exp_NAME.c defines: whoever adds one writes that file and a line here. A first visit to the
 * page has no room for those beside (web/CMakeLists.txt). */
#ifdef SKV_WITHOUT_EXPERIMENTS_BESIDE
#define SKV_EXPERIMENT_BESIDE(X, name)
#else
#define SKV_EXPERIMENT_BESIDE(X, name) X(name)
#endif
#define SKV_EXPERIMENTS(X)                                                                         \
    X(hydrostatics)                                                                                \
    X(rest)                                                                                        \
    X(u_tube)                                                                                      \
    X(vessels)                                                                                     \
    X(slosh)                                                                                       \
    SKV_EXPERIMENT_BESIDE(X, wave_train)                                                           \
    X(dam_break)                                                                                   \
    X(orifice)                                                                                     \
    SKV_EXPERIMENT_BESIDE(X, torricelli)                                                           \
    X(channel)                                                                                     \
    X(archimedes)                                                                                  \
    X(momentum)                                                                                    \
    X(droplet)                                                                                     \
    X(ringing)                                                                                     \
    X(viscosity)
