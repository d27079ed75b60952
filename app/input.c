/* Input: translates toolkit events, and decides nothing: pointers and gravity are the session's.
 * Invariant: every pointer that went down goes up, is cancelled, or dies with a broken grab. */
#include "input.h"

/* The mouse's pointer; touch sequences have addresses of their own. */
#define MOUSE 1

/* Arrow keys. */

enum { LEFT = 1, RIGHT = 2, UP = 4, DOWN = 8 };

typedef struct arrows {
    PlayView *view;
    unsigned held; /* a set of the above */
} arrows;

static unsigned arrow_of(guint key)
{
    switch (key) {
    case GDK_KEY_Left:
    case GDK_KEY_KP_Left:
        return LEFT;
    case GDK_KEY_Right:
    case GDK_KEY_KP_Right:
        return RIGHT;
    case GDK_KEY_Up:
    case GDK_KEY_KP_Up:
        return UP;
    case GDK_KEY_Down:
    case GDK_KEY_KP_Down:
        return DOWN;
    default:
        return 0;
    }
}

/* Gravity points where the held arrows point, and stays there when they are let go. */
static void turn_gravity(const arrows *keys)
{
    double x = !!(keys->held & RIGHT) - !!(keys->held & LEFT);
    double y = !!(keys->held & UP) - !!(keys->held & DOWN);
    double length = sqrt(x * x + y * y);
    if (length > 0)
        play_view_set_gravity(keys->view, x / length, y / length);
}

static gboolean on_key_pressed(G_GNUC_UNUSED GtkEventControllerKey *controller, guint key,
                               G_GNUC_UNUSED guint code, GdkModifierType state, arrows *keys)
{
    unsigned arrow = arrow_of(key);
    if (!arrow || state & (GDK_CONTROL_MASK | GDK_ALT_MASK | GDK_SUPER_MASK))
        return GDK_EVENT_PROPAGATE;
    keys->held |= arrow;
    turn_gravity(keys);
    return GDK_EVENT_STOP;
}

static void on_key_released(G_GNUC_UNUSED GtkEventControllerKey *controller, guint key,
                            G_GNUC_UNUSED guint code, G_GNUC_UNUSED GdkModifierType state,
                            arrows *keys)
{
    keys->held &= ~arrow_of(key);
    turn_gravity(keys);
}

static void on_focus_left(G_GNUC_UNUSED GtkEventControllerFocus *controller, arrows *keys)
{
    keys->held = 0;
}

/* Mouse and fingers. */

/* The event's place in the view's device pixels. */
static bool locate(PlayView *view, GdkEvent *event, double *x, double *y)
{
    GtkWidget *widget = GTK_WIDGET(view);
    GtkNative *native = gtk_widget_get_native(widget);
    double surface_x, surface_y, shift_x, shift_y;
    if (!native || !gdk_event_get_position(event, &surface_x, &surface_y))
        return false;
    gtk_native_get_surface_transform(native, &shift_x, &shift_y);
    if (!gtk_widget_translate_coordinates(GTK_WIDGET(native), widget, surface_x - shift_x,
                                          surface_y - shift_y, x, y))
        return false;
    *x *= gtk_widget_get_scale_factor(widget);
    *y *= gtk_widget_get_scale_factor(widget);
    return true;
}

static void press(PlayView *view, GdkEvent *event, guint64 pointer)
{
    double x, y;
    gtk_widget_grab_focus(GTK_WIDGET(view));
    if (locate(view, event, &x, &y))
        skv_session_pointer_down(play_view_session(view), pointer, x, y,
                                 gdk_event_get_time(event) / 1000.0);
}

static void move(PlayView *view, GdkEvent *event, guint64 pointer)
{
    double x, y;
    if (locate(view, event, &x, &y))
        skv_session_pointer_move(play_view_session(view), pointer, x, y,
                                 gdk_event_get_time(event) / 1000.0);
}

static guint64 finger_of(GdkEvent *event)
{
    return (guint64)GPOINTER_TO_SIZE(gdk_event_get_event_sequence(event));
}

static gboolean on_event(G_GNUC_UNUSED GtkEventControllerLegacy *controller, GdkEvent *event,
                         PlayView *view)
{
    skv_session *session = play_view_session(view);
    switch (gdk_event_get_event_type(event)) {
    case GDK_BUTTON_PRESS:
        if (gdk_button_event_get_button(event) != GDK_BUTTON_PRIMARY)
            return GDK_EVENT_PROPAGATE;
        press(view, event, MOUSE);
        break;
    case GDK_BUTTON_RELEASE:
        if (gdk_button_event_get_button(event) != GDK_BUTTON_PRIMARY)
            return GDK_EVENT_PROPAGATE;
        skv_session_pointer_up(session, MOUSE);
        break;
    case GDK_MOTION_NOTIFY:
        if (skv_session_pointer_count(session) == 0)
            return GDK_EVENT_PROPAGATE;
        move(view, event, MOUSE);
        break;
    case GDK_TOUCH_BEGIN:
        press(view, event, finger_of(event));
        break;
    case GDK_TOUCH_UPDATE:
        move(view, event, finger_of(event));
        break;
    case GDK_TOUCH_END:
    case GDK_TOUCH_CANCEL:
        skv_session_pointer_up(session, finger_of(event));
        break;
    case GDK_GRAB_BROKEN:
        skv_session_pointer_cancel_all(session);
        break;
    default:
        return GDK_EVENT_PROPAGATE;
    }
    gtk_gl_area_queue_render(GTK_GL_AREA(view)); /* the rings move also while paused */
    return GDK_EVENT_STOP;
}

void play_input_attach(PlayView *view)
{
    GtkWidget *widget = GTK_WIDGET(view);
    arrows *keys = g_new0(arrows, 1);
    keys->view = view;
    g_object_set_data_full(G_OBJECT(view), "arrows", keys, g_free);

    GtkEventController *controller = gtk_event_controller_key_new();
    g_signal_connect(controller, "key-pressed", G_CALLBACK(on_key_pressed), keys);
    g_signal_connect(controller, "key-released", G_CALLBACK(on_key_released), keys);
    gtk_widget_add_controller(widget, controller);

    controller = gtk_event_controller_focus_new();
    g_signal_connect(controller, "leave", G_CALLBACK(on_focus_left), keys);
    gtk_widget_add_controller(widget, controller);

    controller = gtk_event_controller_legacy_new();
    g_signal_connect(controller, "event", G_CALLBACK(on_event), view);
    gtk_widget_add_controller(widget, controller);
}
