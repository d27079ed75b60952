/* Tools: buttons made from the session's table. Invariant: no tool is named here; a new row of the
 * table is a new button, with a picture of its own if icons/ has one of its name. */
#include "tools.h"

#include "words.h"

static char *icon_of(const skv_tool *tool)
{
    char *icon = g_strdup_printf("skvalp-%s-symbolic", tool->name);
    GtkIconTheme *theme = gtk_icon_theme_get_for_display(gdk_display_get_default());
    if (!gtk_icon_theme_has_icon(theme, icon)) {
        g_free(icon);
        icon = g_strdup("skvalp-probe-symbolic");
    }
    return icon;
}

/* The button of a tool that dyes shows and says the colour. */
static void show_dye(PlayView *view, GtkWidget *button)
{
    int chosen = skv_stage_dye(play_view_stage(view));
    const char *name;
    for (int dye = 0; (name = skv_dye_name(dye)); dye++) {
        char *class = g_strdup_printf("dye-%s", name);
        if (dye != chosen) {
            gtk_widget_remove_css_class(button, class);
        } else if (!gtk_widget_has_css_class(button, class)) {
            gtk_widget_add_css_class(button, class);
            /* Translators: the colour of the tool that dyes. */
            char *label = g_strdup_printf(_("Dye: %s"), play_word(name));
            gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                           label, -1);
            g_free(label);
        }
        g_free(class);
    }
}

/* The button of a tool that drops bodies says their shape. */
static void show_shape(PlayView *view, GtkWidget *button)
{
    int chosen = skv_stage_shape(play_view_stage(view));
    if (g_object_get_data(G_OBJECT(button), "skvalp-shape") == GINT_TO_POINTER(chosen + 1))
        return;
    g_object_set_data(G_OBJECT(button), "skvalp-shape", GINT_TO_POINTER(chosen + 1));
    /* Translators: the shape of the tool that drops bodies. */
    char *label = g_strdup_printf(_("Body: %s"), play_word(skv_drop_shape(chosen)));
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, label,
                                   -1);
    g_free(label);
}

static GtkWidget *make_button(int number, const skv_tool *tool)
{
    GtkWidget *button = gtk_toggle_button_new();
    char *icon = icon_of(tool);
    GtkWidget *image = gtk_image_new_from_icon_name(icon);
    gtk_image_set_pixel_size(GTK_IMAGE(image), 20);
    gtk_button_set_child(GTK_BUTTON(button), image);
    g_free(icon);
    /* Translators: a tool, the key that chooses it, and what it does. */
    char *tip =
        g_strdup_printf(_("%s (%c)\n%s"), play_word(tool->title), tool->key, play_word(tool->help));
    gtk_widget_set_tooltip_text(button, tip);
    g_free(tip);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   play_word(tool->title), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   play_word(tool->help), -1);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), "win.tool");
    gtk_actionable_set_action_target(GTK_ACTIONABLE(button), "i", number);
    gtk_widget_set_focus_on_click(button, FALSE);
    gtk_widget_add_css_class(button, "tool");
    gtk_widget_add_css_class(button, "flat");
    return button;
}

GtkWidget *play_tools_menu_button(const char *icon, const char *name, const char *tip)
{
    GtkWidget *button = gtk_menu_button_new();
    gtk_menu_button_set_icon_name(GTK_MENU_BUTTON(button), icon);
    gtk_widget_set_tooltip_text(button, tip);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    gtk_widget_add_css_class(button, "tool");
    gtk_widget_add_css_class(button, "flat");
    return button;
}

/* The brush's size. */

static double world_size(PlayView *view)
{
    const skv_camera camera = skv_stage_camera(play_view_stage(view), 0);
    return MAX(camera.world_width, camera.world_height);
}

static void on_size_changed(GtkRange *range, PlayView *view)
{
    double size = exp(gtk_range_get_value(range)) * world_size(view);
    if (fabs(size / play_view_picture(view)->brush - 1) > 0.01)
        skv_control_brush(play_view_stage(view), size);
}

static void on_size_shown(GtkWidget *scale, PlayView *view)
{
    double share = play_view_picture(view)->brush / world_size(view);
    gtk_range_set_value(GTK_RANGE(scale), log(share)); /* which keeps to its ends */
}

static GtkWidget *make_size_button(PlayView *view)
{
    const skv_limits *limits = skv_control_limits();
    GtkWidget *scale = gtk_scale_new_with_range(
        GTK_ORIENTATION_HORIZONTAL, log(limits->least_brush), log(limits->largest_brush), 0.1);
    gtk_scale_set_draw_value(GTK_SCALE(scale), FALSE);
    gtk_widget_set_size_request(scale, 200, 48);
    gtk_accessible_update_property(GTK_ACCESSIBLE(scale), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Size of the tool"), -1);
    g_signal_connect(scale, "value-changed", G_CALLBACK(on_size_changed), view);
    g_signal_connect(scale, "map", G_CALLBACK(on_size_shown), view);
    GtkWidget *popover = gtk_popover_new();
    gtk_popover_set_child(GTK_POPOVER(popover), scale);

    GtkWidget *button = play_tools_menu_button("skvalp-size-symbolic", _("Size of the tool"),
                                               _("Size of the tool (wheel, or [ and ])"));
    gtk_menu_button_set_popover(GTK_MENU_BUTTON(button), popover);
    return button;
}

void play_tools_fill(GtkBox *box, PlayView *view)
{
    const skv_tool *tool;
    for (int i = 0; (tool = skv_tool_info(i)); i++) {
        GtkWidget *button = make_button(i, tool);
        gtk_box_append(box, button);
        void (*show)(PlayView *, GtkWidget *) = tool->dyes    ? show_dye
                                                : tool->drops ? show_shape
                                                              : NULL;
        if (!show)
            continue;
        show(view, button);
        g_signal_connect_object(view, "changed", G_CALLBACK(show), button, 0);
    }
    gtk_box_append(box, make_size_button(view));
}
