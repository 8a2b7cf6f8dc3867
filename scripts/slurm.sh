#!/usr/bin/env bash
# Runs a sweep on a Slurm cluster: an array with a shard a task, and a job after
# it that merges the shards. docs/cluster.md explains what happens then.
#
#   scripts/slurm.sh SWEEP.toml SHARDS [OUT] [-- SBATCH-OPTION...]
#
# SHARDS   how many parts, at most 1000
# OUT      results folder, seen by all nodes [default: results/NAME]
# options  for both jobs, such as --time=4:00:00 --cpus-per-task=16 --partition=short
#
# $SWEEP     the program [default: sweep, on the PATH]
# $MARGIN_S  how long before its time limit a task asks to continue later [default: 60]
set -euo pipefail

refuse() {
    printf 'slurm.sh: %s\n' "$*" >&2
    exit 2
}

usage="usage: scripts/slurm.sh SWEEP.toml SHARDS [OUT] [-- SBATCH-OPTION...]"
arguments=()
while [[ $# -gt 0 && $1 != -- ]]; do
    arguments+=("$1")
    shift
done
[[ $# -eq 0 ]] || shift
options=("$@")
[[ ${#arguments[@]} -eq 2 || ${#arguments[@]} -eq 3 ]] || refuse "$usage"

file=${arguments[0]}
shards=${arguments[1]}
name=$(basename "$file" .toml)
out=${arguments[2]:-results/$name}
margin=${MARGIN_S:-60}

[[ -f $file ]] || refuse "there is no sweep file $file"
[[ $shards =~ ^[1-9][0-9]*$ ]] || refuse "SHARDS is a number from 1 to 1000, not $shards"
# Slurm's MaxArraySize is 1001 unless the cluster says otherwise.
[[ ${#shards} -le 4 && $shards -le 1000 ]] ||
    refuse "at most 1000 shards, not $shards: a Slurm array has no more tasks by default"
[[ $margin =~ ^[1-9][0-9]{0,5}$ ]] || refuse "MARGIN_S is a number of seconds, not $margin"
for option in ${options[@]+"${options[@]}"}; do
    case $option in
        -a* | --array* | -d* | --dep* | -o* | --output* | -W | --wait)
            refuse "$option is for this script to say" ;;
        *$'\n'*) refuse "an option with a line break: $option" ;;
        -*) ;;
        *) refuse "an option and its value in one word, as --time=60, not apart: $option" ;;
    esac
done
program=$(command -v -- "${SWEEP:-sweep}") ||
    refuse "there is no program ${SWEEP:-sweep}: put it on the PATH or name it in SWEEP"
command -v sbatch >/dev/null || refuse "there is no sbatch on the PATH: is this a Slurm cluster?"

# The jobs get paths that hold wherever they start.
mkdir -p -- "$out/slurm"
program=$(realpath -- "$program")
file=$(realpath -- "$file")
out=$(realpath -- "$out")
logs=${out//%/%%}/slurm # in file names, sbatch replaces what begins with %

# An #SBATCH line; within quotes, sbatch takes all but \ and " as it is.
directive() {
    local text=${1//\\/\\\\}
    printf '#SBATCH "%s"\n' "${text//\"/\\\"}"
}

directives() {
    printf '#!/usr/bin/env bash\n'
    local each
    for each in "$@"; do directive "$each"; done
}

{
    directives --job-name="$name" --nodes=1 --ntasks=1 ${options[@]+"${options[@]}"} \
        --array="0-$((shards - 1))" --requeue --open-mode=append --output="$logs/shard-%a.log"
    cat <<END
# One shard of a sweep, written by scripts/slurm.sh. To run some shards again:
#   sbatch --array=1,3 THIS-FILE
set -euo pipefail
shard=\$SLURM_ARRAY_TASK_ID
margin=$margin

# At its time limit a task would be ended for good. So it has itself requeued a
# little before: Slurm then stops the program as at the limit, and starts this
# task again when there is room. Not forever, should it never get anywhere.
# By task, since a bare number may mean the whole array.
task=\${SLURM_ARRAY_JOB_ID}_\$shard
end=\$(SLURM_TIME_FORMAT=%s squeue --noheader --jobs="\$task" --format=%e) || end=unknown
if [[ \$end =~ ^[0-9]+\$ && \${SLURM_RESTART_COUNT:-0} -lt 20 ]]; then
    left=\$((end - \$(date +%s)))
    wait=\$((left > margin ? left - margin : left / 2))
    (sleep "\$wait" && exec scontrol requeue "\$task") &
fi

# The program takes the place of this script: Slurm signals no other process.
exec $(printf '%q' "$program") run $(printf '%q' "$file") \\
    --shard "\$shard/$shards" --out $(printf '%q' "$out")/shard-"\$shard"-of-$shards
END
} >"$out/slurm/shards.sh"

{
    directives ${options[@]+"${options[@]}"} --job-name="$name-merge" --nodes=1 --ntasks=1 \
        --cpus-per-task=1 --open-mode=append --output="$logs/merge.log"
    cat <<END
# Merges the shards of a sweep, written by scripts/slurm.sh. If one is not
# finished, the log of this job ends with the numbers of those to run again.
set -euo pipefail
exec $(printf '%q' "$program") merge $(printf '%q' "$out")/shard-*-of-$shards \\
    --out $(printf '%q' "$out")
END
} >"$out/slurm/merge.sh"

array=$(sbatch --parsable "$out/slurm/shards.sh")
array=${array%%;*} # the cluster's name may follow
printf 'array %s: %s in %s shards\n' "$array" "$file" "$shards"
# After any end: a task may fail and succeed later, and the merge sees for itself
# what is finished.
merge=$(sbatch --parsable --dependency="afterany:$array" "$out/slurm/merge.sh")
printf 'merge %s: into %s\n' "${merge%%;*}" "$out"
