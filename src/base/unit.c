/* How people write a unit. Invariant: all but its powers stays as it is. */
#include "base/unit.h"

#include "skvalp/base.h"

void skv_spell_unit(const char *si, char *text, size_t room)
{
    int power = 0;
    while (si[power] && !(si[power] == '^' && si[power + 1] == '2'))
        power++;
    bool square = si[power] != '\0';
    skv_format(text, room, "%.*s%s%s", power, si, square ? "²" : "", square ? si + power + 2 : "");
}
