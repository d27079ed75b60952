/* Input: translates toolkit events, and decides nothing: pointers and gravity are the session's.
 * Invariant: every pointer that went down goes up, is cancelled, or dies with a broken grab. */
#include "input.h"

#include <skvalp/controls.h>

#include <math.h>

/* Keys. */

enum { LEFT = 1, RIGHT = 2, UP = 4, DOWN = 8 };

typedef struct keys {
    PlayView *view;
    unsigned held; /* a set of the above */
    bool hand;     /* arrows move a hand */
    bool closed;   /* which holds */
} keys;

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

/* The world that has the focus, of two. */
static PlayView *target(const keys *k)
{
    PlayView *twin = play_view_twin(k->view);
    return twin && gtk_widget_has_focus(GTK_WIDGET(twin)) ? twin : k->view;
}

/* The hand moves while arrows are held; gravity points where they point, and stays there when they
 * are let go. */
static void apply_arrows(const keys *k)
{
    int x = !!(k->held & RIGHT) - !!(k->held & LEFT);
    int y = !!(k->held & UP) - !!(k->held & DOWN);
    double length = sqrt((double)(x * x + y * y));
    if (k->hand)
        skv_stage_keyboard(play_view_stage(target(k)), play_view_side(target(k)), x, y, k->closed);
    else if (length > 0)
        skv_stage_set_gravity(play_view_stage(target(k)), play_view_side(target(k)), x / length,
                              y / length);
}

/* Arrows belong to what has the focus if that is a text, a scale, a list, a menu or a chip. */
static bool is_taken(GtkWidget *window, const keys *k)
{
    GtkWidget *focus = gtk_window_get_focus(GTK_WINDOW(window));
    if (!gtk_widget_get_mapped(GTK_WIDGET(k->view)))
        return true;
    if (!focus || PLAY_IS_VIEW(focus))
        return false;
    GtkWidget *menu = gtk_widget_get_ancestor(focus, GTK_TYPE_MENU_BUTTON);
    return !GTK_IS_BUTTON(focus) || gtk_widget_get_ancestor(focus, GTK_TYPE_POPOVER) ||
           (menu && gtk_widget_has_css_class(menu, "chip"));
}

static bool on_hand_key(keys *k, guint key)
{
    if (!k->hand || (key != GDK_KEY_Return && key != GDK_KEY_KP_Enter))
        return false;
    k->closed = !k->closed;
    apply_arrows(k);
    return true;
}

static gboolean on_key_pressed(GtkEventControllerKey *controller, guint key,
                               G_GNUC_UNUSED guint code, GdkModifierType state, keys *k)
{
    GtkWidget *window = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(controller));
    unsigned arrow = arrow_of(key);
    if (state & (GDK_CONTROL_MASK | GDK_ALT_MASK | GDK_SUPER_MASK) || is_taken(window, k))
        return GDK_EVENT_PROPAGATE;
    if (on_hand_key(k, key))
        return GDK_EVENT_STOP;
    if (!arrow)
        return GDK_EVENT_PROPAGATE;
    if (state & GDK_SHIFT_MASK && arrow & (LEFT | RIGHT)) {
        skv_control_go(play_view_stage(k->view),
                       skv_control_limits()->frames_a_second * (arrow == LEFT ? -1 : 1));
        return GDK_EVENT_STOP;
    }
    k->held |= arrow;
    apply_arrows(k);
    return GDK_EVENT_STOP;
}

static void on_key_released(G_GNUC_UNUSED GtkEventControllerKey *controller, guint key,
                            G_GNUC_UNUSED guint code, G_GNUC_UNUSED GdkModifierType state, keys *k)
{
    if (!(k->held & arrow_of(key)))
        return;
    k->held &= ~arrow_of(key);
    apply_arrows(k);
}

static void on_focus_left(G_GNUC_UNUSED GtkEventControllerFocus *controller, keys *k)
{
    k->held = 0;
    apply_arrows(k);
}

void play_input_set_keyboard_hand(GtkWidget *window, gboolean shown)
{
    keys *k = g_object_get_data(G_OBJECT(window), "keys");
    k->hand = shown;
    k->held = 0;
    k->closed = false;
    skv_stage_keyboard(play_view_stage(k->view), play_view_side(k->view), 0, 0, false);
}

void play_input_attach_keys(GtkWidget *window, PlayView *view)
{
    keys *k = g_new0(keys, 1);
    k->view = view;
    g_object_set_data_full(G_OBJECT(window), "keys", k, g_free);

    GtkEventController *controller = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(controller, GTK_PHASE_CAPTURE);
    g_signal_connect(controller, "key-pressed", G_CALLBACK(on_key_pressed), k);
    g_signal_connect(controller, "key-released", G_CALLBACK(on_key_released), k);
    gtk_widget_add_controller(window, controller);

    controller = gtk_event_controller_focus_new();
    g_signal_connect(controller, "leave", G_CALLBACK(on_focus_left), k);
    gtk_widget_add_controller(window, controller);
}

/* Mouse and fingers. */

#define TREMBLE 12 /* pixels of the toolkit */

typedef struct pointers {
    PlayView *view;
    guint waiting; /* for the time of one that waits; 0: none does */
    double x, y;   /* where it was last, in the view's device pixels: a wheel tells no place */
} pointers;

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

static skv_device device_of(GdkEvent *event)
{
    GdkDevice *device = gdk_event_get_device(event);
    GdkDeviceTool *tool = gdk_event_get_device_tool(event);
    if (gdk_event_get_event_sequence(event))
        return SKV_DEVICE_FINGER;
    if (tool && gdk_device_tool_get_tool_type(tool) == GDK_DEVICE_TOOL_TYPE_ERASER)
        return SKV_DEVICE_ERASER;
    bool pen = device && gdk_device_get_source(device) == GDK_SOURCE_PEN;
    return pen ? SKV_DEVICE_PEN : SKV_DEVICE_MOUSE;
}

static gboolean on_waited(gpointer data);

/* What is due in so many seconds if nothing comes before. */
static void wait(pointers *p, double seconds)
{
    g_clear_handle_id(&p->waiting, g_source_remove);
    if (seconds > 0)
        p->waiting = g_timeout_add((guint)ceil(1000 * seconds), on_waited, p);
}

static gboolean on_waited(gpointer data)
{
    pointers *p = data;
    p->waiting = 0;
    wait(p, skv_stage_touch_waited(play_view_stage(p->view), play_view_side(p->view)));
    return G_SOURCE_REMOVE;
}

static void cancel(pointers *p)
{
    wait(p, 0);
    skv_stage_cancel_pointers(play_view_stage(p->view));
}

static void free_pointers(gpointer data)
{
    pointers *p = data;
    g_clear_handle_id(&p->waiting, g_source_remove);
    g_free(p);
}

/* What mouse, pen and fingers do goes one way. */
static void send(pointers *p, GdkEvent *event, skv_phase phase)
{
    PlayView *view = p->view;
    skv_pointer_event sent = {
        .phase = phase,
        .device = device_of(event),
        .pointer = (guint64)GPOINTER_TO_SIZE(gdk_event_get_event_sequence(event)),
        .time = gdk_event_get_time(event) / 1000.0,
        .straight = (gdk_event_get_modifier_state(event) & GDK_SHIFT_MASK) != 0,
    };
    GdkEventType type = gdk_event_get_event_type(event);
    if (type == GDK_BUTTON_PRESS)
        sent.secondary = gdk_button_event_get_button(event) == GDK_BUTTON_SECONDARY;
    /* GTK crashes on this question where a mouse button was let go. */
    if (sent.device == SKV_DEVICE_PEN || sent.device == SKV_DEVICE_ERASER)
        gdk_event_get_axis(event, GDK_AXIS_PRESSURE, &sent.pressure);
    if (phase == SKV_PHASE_DOWN)
        gtk_widget_grab_focus(GTK_WIDGET(view));
    bool located = locate(view, event, &sent.px, &sent.py);
    if (located) {
        p->x = sent.px;
        p->y = sent.py;
    }
    if (located || phase == SKV_PHASE_UP || phase == SKV_PHASE_LEAVE)
        wait(p, skv_stage_touch(play_view_stage(view), play_view_side(view), &sent,
                                TREMBLE * gtk_widget_get_scale_factor(GTK_WIDGET(view))));
}

/* The wheel sizes the tool; with Ctrl, and by a touchpad's pinch, the picture is zoomed. */
static void zoom(pointers *p, double factor)
{
    skv_stage_zoom(play_view_stage(p->view), play_view_side(p->view), factor, p->x, p->y);
}

static void scroll(pointers *p, GdkEvent *event)
{
    double dx = 0, dy = 0;
    GdkScrollDirection direction = gdk_scroll_event_get_direction(event);
    if (direction == GDK_SCROLL_SMOOTH)
        gdk_scroll_event_get_deltas(event, &dx, &dy);
    else
        dy = (direction == GDK_SCROLL_DOWN) - (direction == GDK_SCROLL_UP);
    double factor = pow(1.15, -dy);
    if (gdk_event_get_modifier_state(event) & GDK_CONTROL_MASK)
        zoom(p, factor);
    else
        skv_control_scale_brush(play_view_stage(p->view), factor);
}

static void pinch(pointers *p, GdkEvent *event)
{
    static double before = 1; /* the scale is that since the pinch began */
    double scale = gdk_touchpad_event_get_pinch_scale(event);
    if (gdk_touchpad_event_get_gesture_phase(event) == GDK_TOUCHPAD_GESTURE_PHASE_BEGIN)
        before = 1;
    else if (scale > 0) {
        zoom(p, scale / before);
        before = scale;
    }
}

static gboolean on_button(pointers *p, GdkEvent *event)
{
    guint button = gdk_button_event_get_button(event);
    if (button != GDK_BUTTON_PRIMARY && button != GDK_BUTTON_SECONDARY)
        return GDK_EVENT_PROPAGATE;
    send(p, event,
         gdk_event_get_event_type(event) == GDK_BUTTON_PRESS ? SKV_PHASE_DOWN : SKV_PHASE_UP);
    return GDK_EVENT_STOP;
}

static gboolean on_event(G_GNUC_UNUSED GtkEventControllerLegacy *controller, GdkEvent *event,
                         pointers *p)
{
    switch (gdk_event_get_event_type(event)) {
    case GDK_BUTTON_PRESS:
    case GDK_BUTTON_RELEASE:
        return on_button(p, event);
    case GDK_SCROLL:
        scroll(p, event);
        return GDK_EVENT_STOP;
    case GDK_TOUCHPAD_PINCH:
        pinch(p, event);
        return GDK_EVENT_STOP;
    case GDK_TOUCH_BEGIN:
        send(p, event, SKV_PHASE_DOWN);
        return GDK_EVENT_STOP;
    case GDK_ENTER_NOTIFY:
        locate(p->view, event, &p->x, &p->y);
        return GDK_EVENT_PROPAGATE;
    case GDK_MOTION_NOTIFY:
        send(p, event, SKV_PHASE_MOVE);
        return GDK_EVENT_PROPAGATE;
    case GDK_TOUCH_UPDATE:
        send(p, event, SKV_PHASE_MOVE);
        return GDK_EVENT_STOP;
    case GDK_TOUCH_END:
        send(p, event, SKV_PHASE_UP);
        return GDK_EVENT_STOP;
    case GDK_LEAVE_NOTIFY:
        send(p, event, SKV_PHASE_LEAVE);
        return GDK_EVENT_PROPAGATE;
    case GDK_TOUCH_CANCEL:
        send(p, event, SKV_PHASE_LEAVE);
        return GDK_EVENT_STOP;
    case GDK_GRAB_BROKEN:
        cancel(p);
        return GDK_EVENT_STOP;
    default:
        return GDK_EVENT_PROPAGATE;
    }
}

/* The middle button moves the picture. */
static void on_pan(GtkGestureDrag *drag, double x, double y, PlayView *view)
{
    double *last = g_object_get_data(G_OBJECT(drag), "last");
    int scale = gtk_widget_get_scale_factor(GTK_WIDGET(view));
    skv_stage_pan(play_view_stage(view), play_view_side(view), (x - last[0]) * scale,
                  (y - last[1]) * scale);
    last[0] = x;
    last[1] = y;
}

static void on_pan_begin(GtkGestureDrag *drag, G_GNUC_UNUSED double x, G_GNUC_UNUSED double y,
                         G_GNUC_UNUSED PlayView *view)
{
    g_object_set_data_full(G_OBJECT(drag), "last", g_new0(double, 2), g_free);
}

void play_input_attach(PlayView *view)
{
    pointers *p = g_new0(pointers, 1);
    p->view = view;
    g_object_set_data_full(G_OBJECT(view), "pointers", p, free_pointers);

    GtkEventController *controller = gtk_event_controller_legacy_new();
    g_signal_connect(controller, "event", G_CALLBACK(on_event), p);
    gtk_widget_add_controller(GTK_WIDGET(view), controller);

    GtkGesture *drag = gtk_gesture_drag_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(drag), GDK_BUTTON_MIDDLE);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_pan_begin), view);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_pan), view);
    gtk_widget_add_controller(GTK_WIDGET(view), GTK_EVENT_CONTROLLER(drag));
}
