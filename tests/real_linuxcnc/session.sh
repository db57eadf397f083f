#!/bin/bash
# session.sh FOLDER INI SECONDS: run one LinuxCNC without a screen; ends when its display program ends, at latest after SECONDS.
#
# LinuxCNC's start script stops other LinuxCNC programs on the same computer by their names and shares lock files, memory keys
# and a network port with them. So each session gets its own processes, memory keys, network and /tmp: nothing else is
# touched and nothing stays behind.
set -eu
folder=$(cd "$1" && pwd)
ini=$2
seconds=$3
rights=()
if [ "$(id -u)" != 0 ]; then
    rights=(--user --map-current-user --keep-caps)
fi
exec timeout --kill-after=5 "$seconds" \
    unshare "${rights[@]}" --pid --fork --kill-child --mount-proc --ipc --net --mount \
    bash -euc '
        # keep the folder reachable, then cover /tmp with an empty one
        mount --rbind "$1" /mnt
        mount -t tmpfs -o mode=1777 tmpfs /tmp
        mkdir /tmp/session
        mount --rbind /mnt /tmp/session
        mkdir -m 777 /tmp/home
        cd /tmp/session
        # RTAPI_UID: root is refused without a user to fall back to
        exec env -i PATH=/usr/bin:/bin LC_ALL=C HOME=/tmp/home RTAPI_UID=65534 linuxcnc -r "$2" </dev/null
    ' session "$folder" "$ini"
