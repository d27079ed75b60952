#!/usr/bin/env bash
# Every text of the app and of the tables it shows is translated, in every language of po/, and is
# found when the app starts in that language. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_translations.sh BUILD SOURCE}")
cd "${2:?usage: test_translations.sh BUILD SOURCE}"
for program in xgettext msgfmt msgmerge msgcomm; do
    command -v "$program" >/dev/null || {
        echo "$program is missing: install gettext"
        exit 1
    }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

scripts/update-po.sh "$build" --template >"$work/all.pot"
texts=$(grep -c '^msgid ' "$work/all.pot")
((texts > 300)) || {
    echo "only $texts texts were found"
    exit 1
}
bad=0 languages=0
# Numbers with decimals go into texts as play_number and numbers.ts write them.
if grep -nE '^msgid.*%[-+ 0-9.]*l?[aefgAEFG]' "$work/all.pot"; then
    echo "a text has printf write a number with decimals; give it %s and a number of skvalp/numbers.h"
    bad=1
fi
for file in po/*.po; do
    languages=$((languages + 1))
    msgmerge --quiet --no-fuzzy-matching -o "$work/merged.po" "$file" "$work/all.pot"
    state=$(LC_ALL=C msgfmt --check --statistics -o /dev/null "$work/merged.po" 2>&1)
    if [[ $state == *fuzzy* || $state == *untranslated* ]]; then
        echo "$file: $state; run scripts/update-po.sh and translate:"
        LC_ALL=C msgattrib --untranslated --no-obsolete "$work/merged.po" | grep '^msgid ".' | head -n 10
        bad=1
    fi
    # What is there and no longer said.
    LC_ALL=C msgattrib --only-obsolete "$work/merged.po" | grep '^#~ msgid' && bad=1
    language=$(basename "$file" .po)
    [[ -s $build/po/$language/LC_MESSAGES/skvalp.mo ]] || {
        echo "$build/po/$language/LC_MESSAGES/skvalp.mo was not built"
        bad=1
    }
done
# Who builds the app alone, as run.sh does, has them, too.
[[ $(ninja -C "$build" -t query skvalp-play) == *po/translations* ]] || {
    echo "skvalp-play is built without its translations"
    bad=1
}
# What C files say to people goes through gettext: labels, tooltips and what plots have written at
# them that are plain texts do not, nor what tables of the library hold.
said='set_tooltip_text|set_label|set_title|label_new|with_label|with_mnemonic|_toast|complain'
said+='|placeholder_text|PROPERTY_LABEL|PROPERTY_DESCRIPTION|play_plot_show|write_text|curve_of|PlayCurve\)'
tables='(curve|info|theory|channel|experiment|row|scene|tool|field|legend|scale|choice|overlay)'
fields='(label|title|description|help|x_label|y_label|quantity)'
translated='(play_word|play_words_of_quantity|gettext|_)'
# untranslated FILE: a statement a line, what is translated taken out.
untranslated() {
    tr '\n' ' ' <"$1" | sed -E "s/\\b$translated\([^()]*(\([^()]*\))?[^()]*\)/+/g" | tr ';' '\n' |
        grep -E "($said).*[({,:?] *\"[A-Za-z]{3,}|($said|g_strdup)\(.*\b($tables->$fields|(info|theory|channel)->name)\b" |
        grep -vE '"Skvalp"|define' || true
}
for file in app/*.c; do
    while IFS= read -r line; do
        echo "not translated: $file: ${line:0:200}"
        bad=1
    done < <(untranslated "$file")
done
# A curve's label is a text in the call that begins it, or marked where it is written.
while IFS= read -r file; do
    grep -q 'PLOT_LABEL("' "$file" || {
        echo "not translated: $file: labels without PLOT_LABEL"
        bad=1
    }
done < <(grep -lE 'skv_plot_(begin|swing)\([^,]*, [^"]' src/experiments/exp_*.c)
while IFS= read -r line; do
    echo "not translated: $line"
    bad=1
done < <(grep -nE '<(property|attribute) name="(title|label|tooltip-text)">[A-Za-z]' app/resources/*.ui |
    grep -v 'Skvalp<' || true)
((bad == 0)) || exit 1
echo "translations: $texts texts, complete in $languages language(s) besides English"
