/* The gallery: scenes as cards that flow in as many columns as fit. Invariant: a card is whole
 * without its picture, which comes when it is ready. */
#include "gallery.h"

#include <skvalp/scene.h>

#include "cards.h"
#include "thumbnails.h"
#include "words.h"

typedef struct gallery {
    GHashTable *pictures; /* of widgets, by the scene's name */
    GCancellable *stop;
    skv_render_style style;
    bool begun;
} gallery;

static GtkWidget *make_text(const char *text, const char *class)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_width_chars(GTK_LABEL(label), 20);
    gtk_label_set_max_width_chars(GTK_LABEL(label), 34);
    gtk_widget_add_css_class(label, class);
    return label;
}

static GtkWidget *make_card(gallery *g, const skv_scene_info *scene)
{
    GtkWidget *picture = gtk_picture_new();
    gtk_widget_set_size_request(picture, -1, 150);
    gtk_picture_set_content_fit(GTK_PICTURE(picture), GTK_CONTENT_FIT_COVER);
    gtk_widget_add_css_class(picture, "thumbnail");
    gtk_widget_set_overflow(picture, GTK_OVERFLOW_HIDDEN);
    gtk_picture_set_alternative_text(GTK_PICTURE(picture), play_word(scene->title));
    g_hash_table_insert(g->pictures, (gpointer)scene->name, picture);

    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    gtk_box_append(GTK_BOX(box), picture);
    gtk_box_append(GTK_BOX(box), make_text(play_word(scene->title), "heading"));
    gtk_box_append(GTK_BOX(box), make_text(play_word(scene->description), "caption"));

    GtkWidget *card = gtk_button_new();
    gtk_button_set_child(GTK_BUTTON(card), box);
    gtk_widget_set_valign(card, GTK_ALIGN_START);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(card), "win.open-scene");
    gtk_actionable_set_action_target(GTK_ACTIONABLE(card), "s", scene->name);
    gtk_accessible_update_property(GTK_ACCESSIBLE(card), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   play_word(scene->title), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   play_word(scene->description), -1);
    gtk_widget_add_css_class(card, "scene");
    gtk_widget_add_css_class(card, "card");
    return card;
}

static void on_thumbnail(const char *name, GdkTexture *texture, gpointer data)
{
    const gallery *g = data;
    gtk_picture_set_paintable(g_hash_table_lookup(g->pictures, name), GDK_PAINTABLE(texture));
}

static void on_shown(G_GNUC_UNUSED GtkWidget *page, gallery *g)
{
    if (g->begun)
        return;
    g->begun = true;
    GPtrArray *names = g_ptr_array_new();
    const skv_scene_info *scene;
    for (int i = 0; (scene = skv_builtin_scene(i)); i++)
        g_ptr_array_add(names, (gpointer)scene->name);
    g_ptr_array_add(names, NULL);
    play_thumbnails_make((const char *const *)names->pdata, &g->style, g->stop, on_thumbnail, g);
    g_ptr_array_free(names, TRUE);
}

static void free_gallery(gpointer data)
{
    gallery *g = data;
    g_cancellable_cancel(g->stop);
    g_object_unref(g->stop);
    g_hash_table_unref(g->pictures);
    g_free(g);
}

GtkWidget *play_gallery_new(const skv_render_style *style)
{
    gallery *g = g_new0(gallery, 1);
    g->pictures = g_hash_table_new(g_str_hash, g_str_equal);
    g->stop = g_cancellable_new();
    g->style = *style;

    GtkWidget *cards = gtk_flow_box_new();
    gtk_flow_box_set_selection_mode(GTK_FLOW_BOX(cards), GTK_SELECTION_NONE);
    gtk_flow_box_set_max_children_per_line(GTK_FLOW_BOX(cards), 5);
    gtk_flow_box_set_homogeneous(GTK_FLOW_BOX(cards), TRUE);
    gtk_flow_box_set_column_spacing(GTK_FLOW_BOX(cards), 12);
    gtk_flow_box_set_row_spacing(GTK_FLOW_BOX(cards), 12);
    gtk_widget_set_valign(cards, GTK_ALIGN_START);
    const skv_scene_info *scene;
    for (int i = 0; (scene = skv_builtin_scene(i)); i++)
        gtk_flow_box_insert(GTK_FLOW_BOX(cards), make_card(g, scene), -1);

    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 12);
    gtk_widget_add_css_class(box, "gallery");
    gtk_box_append(GTK_BOX(box), make_text(_("Scenes"), "title-2"));
    gtk_box_append(GTK_BOX(box), cards);
    gtk_box_append(GTK_BOX(box), make_text(_("Experiments"), "title-2"));
    GtkWidget *clamp = adw_clamp_new();
    adw_clamp_set_maximum_size(ADW_CLAMP(clamp), 900);
    adw_clamp_set_child(ADW_CLAMP(clamp), play_cards_list());
    gtk_box_append(GTK_BOX(box), clamp);

    GtkWidget *page = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(page), GTK_POLICY_NEVER,
                                   GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(page), box);
    g_signal_connect(page, "map", G_CALLBACK(on_shown), g);
    g_object_set_data_full(G_OBJECT(page), "gallery", g, free_gallery);
    return page;
}
