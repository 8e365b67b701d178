#!/usr/bin/env bash
# Usage: tests/work/namespaces.sh [FOLDER]
# A capture by a cluster whose head and two workers are in network namespaces of their own, each
# with its own address and caches; the cable of one worker is pulled on the way. The result has to
# have the bytes of one machine's. For root, with Blender's environment in its usual place.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=${1:-$(mktemp -d)}
sockets=$(mktemp -d) # short: Ray's sockets lie in it, and their paths have 107 bytes
net=10.77.0
python=$PWD/.venv/bin/python
export PYTHONPATH=$PWD:$PWD/runtime:$PWD/exporters RAY_USAGE_STATS_ENABLED=0 RAY_worker_niceness=0
export RAY_AUTH_MODE=token RAY_AUTH_TOKEN=$(head -c 32 /dev/urandom | od -An -tx1 | tr -d ' \n')
export RNA_BLENDER_PYTHON=${RNA_BLENDER_PYTHON:-$HOME/.cache/rna-sdk/blender-5.0.1/bin/python}
pids=()

finish() {
    for pid in "${pids[@]}"; do kill -9 -- "-$pid" 2>/dev/null || true; done
    for k in 0 1 2; do ip netns del "rna$k" 2>/dev/null || true; done
    ip link del rna-bridge 2>/dev/null || true
    rm -rf "$sockets"
}
trap finish EXIT

ip link add rna-bridge type bridge
ip link set rna-bridge up
for k in 0 1 2; do
    ip netns add "rna$k"
    ip link add "rna-cable$k" type veth peer name eth0 netns "rna$k"
    ip link set "rna-cable$k" master rna-bridge up
    ip netns exec "rna$k" ip addr add "$net.$((k + 1))/24" dev eth0
    ip netns exec "rna$k" ip link set eth0 up
    ip netns exec "rna$k" ip link set lo up
done

start_node() { # NUMBER ARGUMENTS...
    local k=$1 log=$folder/node-$1.log
    shift
    XDG_CACHE_HOME=$folder/cache-$k setsid ip netns exec "rna$k" .venv/bin/ray start "$@" --block \
        --node-ip-address "$net.$((k + 1))" --temp-dir "$sockets/$k" >"$log" 2>&1 &
    pids+=($!)
    disown
    for _ in $(seq 240); do
        grep -q "runtime started" "$log" && return
        sleep 0.5
    done
    cat "$log" >&2
    exit 1
}

start_node 0 --head --port 6379 --num-cpus 0 --include-dashboard=false
start_node 1 --address "$net.1:6379" --num-cpus 1
start_node 2 --address "$net.1:6379" --num-cpus 1
"$python" -c "from pathlib import Path; from tests.work.real_faults import write_inputs
write_inputs(Path('$folder'))"
settings="--lights 512 --rays 64 --samples 1 --validation-views 1 --validation-resolution 24
    --validation-samples 4 --seed 3"
capture() { # OUT ARGUMENTS...
    local out=$1
    shift
    "$@" -m rna_export.capture.rna_capture "$folder/ball.py" --out "$out" $settings $cluster
}

mkdir -p "$folder/here" "$folder/there"
cluster=""
capture "$folder/here/ball.rays" "$python"
cluster="--cluster $net.1:6379"
capture "$folder/there/ball.rays" ip netns exec rna0 "$python" &
driver=$!
until [ "$(find "$folder/there" -name '0*.safetensors' | wc -l)" -ge 3 ]; do
    kill -0 "$driver"
    sleep 0.2
done
ip link set rna-cable2 down
echo "the cable of the second worker is pulled"
wait "$driver"
diff -r "$folder/here" "$folder/there"
echo "the same bytes; caches of the workers: $(ls "$folder"/cache-[12]/rna-sdk/sources | xargs)"
