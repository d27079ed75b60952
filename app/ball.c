/* The gravity ball: a disc whose middle is weightlessness and whose ring is the scene's own
 * strength; the rim is twice that. Invariant: it shows what the picture says, never what the finger
 * said last. */
#include "ball.h"

#include "words.h"

#define SIZE      72   /* pixels across */
#define STRONGEST 2.0  /* times the scene's own strength, at the rim */
#define SNAP      0.12 /* of the strength: so near to the middle or to the ring it catches */

struct _PlayBall {
    GtkWidget parent;
    PlayView *view;
    double x, y; /* as shown, over the scene's strength, y up */
};

G_DEFINE_FINAL_TYPE(PlayBall, play_ball, GTK_TYPE_WIDGET)

static void circle(GtkSnapshot *snapshot, const GdkRGBA *color, double x, double y, double radius,
                   double line)
{
    GskRoundedRect outline;
    graphene_rect_t box = GRAPHENE_RECT_INIT((float)(x - radius), (float)(y - radius),
                                             (float)(2 * radius), (float)(2 * radius));
    gsk_rounded_rect_init_from_rect(&outline, &box, (float)radius);
    if (line > 0) {
        float width = (float)line;
        gtk_snapshot_append_border(snapshot, &outline, (float[4]){width, width, width, width},
                                   (GdkRGBA[4]){*color, *color, *color, *color});
        return;
    }
    gtk_snapshot_push_rounded_clip(snapshot, &outline);
    gtk_snapshot_append_color(snapshot, color, &box);
    gtk_snapshot_pop(snapshot);
}

static void snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    const PlayBall *ball = PLAY_BALL(widget);
    double middle_x = gtk_widget_get_width(widget) / 2.0;
    double middle_y = gtk_widget_get_height(widget) / 2.0, radius = SIZE / 2.0 - 4;
    GdkRGBA color, faint;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &color);
    faint = color;
    faint.alpha *= 0.55F;
    circle(snapshot, &faint, middle_x, middle_y, radius, 1);
    circle(snapshot, &faint, middle_x, middle_y, radius / STRONGEST, 1);
    circle(snapshot, &faint, middle_x, middle_y, 1.5, 0);
    circle(snapshot, &color, middle_x + ball->x * radius / STRONGEST,
           middle_y - ball->y * radius / STRONGEST, 7, 0);
}

static void on_drag(PlayBall *ball, double px, double py)
{
    double radius = SIZE / 2.0 - 4;
    double x = (px - gtk_widget_get_width(GTK_WIDGET(ball)) / 2.0) / radius * STRONGEST;
    double y = (gtk_widget_get_height(GTK_WIDGET(ball)) / 2.0 - py) / radius * STRONGEST;
    double length = sqrt(x * x + y * y), wanted = MIN(length, STRONGEST);
    if (wanted < SNAP)
        wanted = 0;
    else if (fabs(wanted - 1) < SNAP)
        wanted = 1;
    double factor = length > 0 ? wanted / length : 0;
    skv_stage_set_gravity(play_view_stage(ball->view), play_view_side(ball->view), x * factor,
                          y * factor);
}

static void on_drag_begin(G_GNUC_UNUSED GtkGestureDrag *drag, double x, double y, PlayBall *ball)
{
    on_drag(ball, x, y);
}

static void on_drag_update(GtkGestureDrag *drag, double dx, double dy, PlayBall *ball)
{
    double x, y;
    if (gtk_gesture_drag_get_start_point(drag, &x, &y))
        on_drag(ball, x + dx, y + dy);
}

static void on_changed(PlayBall *ball)
{
    const skv_picture *picture = play_view_picture(ball->view);
    if (ball->x == picture->tilt_x && ball->y == picture->tilt_y)
        return;
    ball->x = picture->tilt_x;
    ball->y = picture->tilt_y;
    double strength = sqrt(ball->x * ball->x + ball->y * ball->y);
    /* Translators: how strong gravity is, against the scene's own. */
    char *text =
        g_strdup_printf(_("%s times as strong as the scene's"), play_number(strength, 1).text);
    gtk_accessible_update_property(GTK_ACCESSIBLE(ball), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text,
                                   -1);
    g_free(text);
    gtk_widget_queue_draw(GTK_WIDGET(ball));
}

void play_ball_attach(PlayBall *ball, PlayView *view)
{
    ball->view = view;
    g_signal_connect_object(view, "changed", G_CALLBACK(on_changed), ball, G_CONNECT_SWAPPED);
}

static void measure(G_GNUC_UNUSED GtkWidget *widget, G_GNUC_UNUSED GtkOrientation orientation,
                    G_GNUC_UNUSED int size, int *minimum, int *natural, int *minimum_baseline,
                    int *natural_baseline)
{
    *minimum = *natural = SIZE;
    *minimum_baseline = *natural_baseline = -1;
}

static void play_ball_class_init(PlayBallClass *class)
{
    GTK_WIDGET_CLASS(class)->snapshot = snapshot;
    GTK_WIDGET_CLASS(class)->measure = measure;
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_IMG);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "ball");
}

static void play_ball_init(PlayBall *ball)
{
    ball->y = -1;
    GtkGesture *drag = gtk_gesture_drag_new();
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_drag_begin), ball);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag_update), ball);
    gtk_widget_add_controller(GTK_WIDGET(ball), GTK_EVENT_CONTROLLER(drag));
    gtk_widget_set_tooltip_text(GTK_WIDGET(ball),
                                _("Gravity: drag the ball to where down is (arrow keys)"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(ball), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Gravity"), -1);
}
