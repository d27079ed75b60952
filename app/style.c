/* Style: what the theme means for a picture. Invariant: one place decides it, for the view, the
 * gallery and videos alike. */
#include "style.h"

void play_style_follow_theme(skv_render_style *style)
{
    AdwStyleManager *styles = adw_style_manager_get_default();
    if (adw_style_manager_get_high_contrast(styles))
        style->palette = SKV_PALETTE_CONTRAST;
    else if (adw_style_manager_get_dark(styles))
        style->palette = SKV_PALETTE_DARK;
    else
        style->palette = SKV_PALETTE_LIGHT;
}
