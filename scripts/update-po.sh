#!/usr/bin/env bash
# Brings po/*.po in line with what the app and the page say: the texts in app/ and web/page/, those of the
# library's tables, its messages, and the labels of the experiments' curves.
# What is new there has to be translated by hand. With --template it prints the template alone.
set -euo pipefail
cd "$(dirname "$0")/.."
program=update-po.sh
# shellcheck source=scripts/lib.sh
source scripts/lib.sh
usage() {
    say "Usage: scripts/update-po.sh [BUILD] [--template]"
}
choose_build "$@"
shift "$chosen"
[[ -x $build/skvalp-strings ]] || die "$build/skvalp-strings is not there; build it with: ninja -C $build"

# The page's texts as calls in C: xgettext does not find its way through TypeScript with elements.
page_texts() {
    # shellcheck disable=SC2016 # it is perl's
    perl -0777 -ne '
        while (/\b(_|N_|ngettext)\(\s*(.(?:\\.|[^\\\x27])*\x27(?:\s*,\s*\x27(?:\\.|[^\\\x27])*\x27)?)/gs) {
            my ($call, $texts) = ($1, $2);
            next unless $texts =~ /^\x27/;
            $texts =~ s/"/\\"/g;
            $texts =~ s/\\\x27/\x00/g;
            $texts =~ tr/\x27\x00/"\x27/;
            print "$call($texts);\n";
        }' web/page/ui/*.ts web/page/ui/*.tsx
}

# What the library says, in whichever file: texts of two words and more, in the form in which app/said.c and
# web/page/ui/said.ts look for them, with %s for whatever is filled in. What memory did not suffice for is
# filled in, too. Of bodies it is also said without that word (src/scene/painted_bodies.c).
# Left out are tables, whose texts skvalp-strings prints, what is said by the command line alone or as a
# program ends, and notes of xgettext.
messages() {
    local silent='/(exp_[a-z_]*|study|study_plot|study_table|sweep|assert|fields|style)\.c$|^src/solver/reference'
    # shellcheck disable=SC2016 # it is perl's
    {
        find src -name '*.c' | grep -vE "$silent" | LC_ALL=C sort
        echo src/base/fields.c
    } | xargs cat | perl -0777 -pe 's/_Static_assert\(.*?\);//gs' |
        xgettext --from-code=UTF-8 --no-location --no-wrap --language=C --extract-all -o - - 2>/dev/null |
        perl -0777 -ne '
            for (/^msgid ("(?:[^"\\]|\\.)*")\nmsgstr/gm) {
                s/%[-+ #0]*(?:[0-9]+|\*)?(?:\.(?:[0-9]+|\*))?(?:hh|h|ll|l|z)?[a-zA-Z]/%s/g;
                s/(?:%s)+/%s/g;
                s/ "$/ %s"/; # what follows is a macro
                s/^(".*)\b(out of|no) memory for [^;"]*/$1$2 memory for %s/;
                s/^"body: /"/;
                my $words = () = /(?<![^ "])[a-z]{2,}(?=[:;]? |")/g;
                if (/[a-z]+ [(]?[a-z]{2,}/ && !/^"</ || $words > 1 && !/%s/) {
                    print "#. a message\nmsgid $_\nmsgstr \"\"\n\n";
                } elsif ($words > 1) {
                    print STDERR "update-po.sh: $_ cannot be found by its words, for no two of them stand together\n";
                    $apart = 1;
                }
            }
            exit $apart // 0'
}

template() {
    local work
    work=$(mktemp -d)
    {
        printf 'msgid ""\nmsgstr "Content-Type: text/plain; charset=UTF-8\\n"\n\n'
        "$build/skvalp-strings"
        messages
    } | msguniq --to-code=UTF-8 -o "$work/tables.pot" -
    xgettext --from-code=UTF-8 --add-comments=Translators --keyword=_ --keyword=N_ \
        --keyword=ngettext:1,2 --no-location --package-name=Skvalp --language=C \
        -o "$work/app.pot" app/*.c
    xgettext --from-code=UTF-8 --no-location --join-existing -o "$work/app.pot" \
        app/resources/*.ui
    # The labels of the experiments' curves, and what an experiment requires.
    xgettext --from-code=UTF-8 --no-location --join-existing --language=C --keyword \
        --keyword=skv_plot_begin:2 --keyword=skv_plot_swing:2 --keyword=PLOT_LABEL \
        --keyword=skv_rig_require:3 \
        -o "$work/app.pot" src/experiments/exp_*.c
    page_texts >"$work/page.c"
    xgettext --from-code=UTF-8 --no-location --join-existing --language=C --keyword=_ --keyword=N_ \
        --keyword=ngettext:1,2 -o "$work/app.pot" "$work/page.c"
    msgcat --use-first --no-location --no-wrap -o - "$work/app.pot" "$work/tables.pot" |
        sed '/^"POT-Creation-Date/d'
    rm -rf "$work"
}

if [[ ${1-} == --template ]]; then
    template
    exit
fi
pot=$(mktemp)
trap 'rm -f "$pot"' EXIT
template >"$pot"
for file in po/*.po; do
    msgmerge --quiet --no-fuzzy-matching --no-location --no-wrap --sort-output -o "$file.new" "$file" "$pot"
    msgattrib --no-obsolete --no-wrap --sort-output -o "$file" "$file.new"
    rm "$file.new"
    say "$file: $(msgfmt --statistics -o /dev/null "$file" 2>&1)"
done
