#!/usr/bin/env bash
# Prints the short table of docs/performance.md from one processor's CSV of skvalp bench.
# Argument: the CSV.
set -euo pipefail

awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    function value(name) { return $column[name] }
    # The laws as they are used: the calibrated one without pair viscosity, Clavet'\''s with it.
    value("viscosity") == (value("law") == "clavet" ? "on" : "off") {
        row = value("scene") "," value("law") "," value("particles")
        if (value("threads") == 1) one[row] = $0; else all[row] = $0
        threads = value("threads") > threads ? value("threads") : threads
        if (!cpu) cpu = value("cpu") ", " value("instruction_set") ", " value("compiler")
    }
    END {
        printf "%s; %d threads\n\n", cpu, threads
        print "| scene | law | particles | substeps a frame | ns, one thread | ns, all threads | speed-up | reference, one thread | bytes |"
        print "|---|---|--:|--:|--:|--:|--:|--:|--:|"
        split("pool dam-break", scenes, " "); split("calibrated clavet", laws, " ")
        sizes = split("3000 10000 100000 1000000", size, " ")
        for (s = 1; s <= 2; s++) for (l = 1; l <= 2; l++) for (n = 1; n <= sizes; n++) {
            row = scenes[s] "," laws[l] "," size[n]
            if (!(row in one)) continue
            split(one[row], a, ","); split(all[row], b, ",")
            ns = a[column["ns_per_particle_substep"]]; least = b[column["ns_per_particle_substep"]]
            slow = a[column["reference_ns_per_particle_substep"]]
            printf "| %s | %s | %d | %d | %.1f | %.1f | %.2f | %s | %.0f |\n", scenes[s], laws[l], size[n],
                a[column["substeps"]], ns, least, ns / least, slow == "" ? "–" : sprintf("%.0f", slow),
                a[column["bytes_per_particle"]]
        }
    }' "${1:?usage: bench-digest.sh CSV}"
