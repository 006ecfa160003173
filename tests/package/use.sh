#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Installs the packages beside this file in the system where it runs, as root, uses all that is in them, and removes them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
examples=/usr/share/doc/hardball/examples

install() {
  apt-get -q -y --no-install-recommends install "$@" >apt.log 2>&1 || { cat apt.log && return 1; }
}

# prints TEXT COMMAND...: fails unless the command succeeds and prints the text.
prints() {
  local output
  output=$("${@:2}") || { echo "failed: ${*:2}" && return 1; }
  [[ $output == *"$1"* ]] || { echo "no '$1' in what ${*:2} prints:" && echo "$output" && return 1; }
}

# refuses TEXT COMMAND...: fails unless the exit status of the command is 2 and its messages have the text.
refuses() {
  local output status=0
  output=$("${@:2}" 2>&1) || status=$?
  [[ $status == 2 && $output == *"$1"* ]] || { echo "exit status $status of ${*:2}: $output" && return 1; }
}

echo "-- the program, with nothing but what it depends on"
install ./hardball_*.deb
dpkg --verify hardball
hardball --version
prints "event_log_hash" hardball run "$examples/newtons_cradle.toml" --json --quiet
prints "all runs are the same" hardball verify "$examples/two_spheres.toml"
hardball replay "$examples/two_spheres.toml" --out page.html && test -s page.html

echo "-- the program in several processes, without MPI and with it"
refuses "install Open MPI (openmpi-bin in Debian)" env OMPI_COMM_WORLD_SIZE=2 hardball run "$examples/newtons_cradle.toml"
install openmpi-bin
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
# All processes are on this machine, where nothing but shared memory may be allowed.
export OMPI_MCA_plm=isolated OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none
hash=$(hardball run "$examples/paper.toml" --until 0.5 --quiet | grep hash)
prints "$hash" mpirun --oversubscribe -n 2 hardball run "$examples/paper.toml" --until 0.5 --quiet

echo "-- manual and completions"
install man-db zsh fish bash-completion
prints "--until" man hardball
prints "finds every collision" whatis hardball
prints "neighbors" fish -c 'complete -C "hardball run --engine "'
prints "--recording-limit" fish -c 'complete -C "hardball view --rec"'
prints "_hardball" zsh -c 'autoload -U compinit && compinit -u && print $_comps[hardball]'
zsh -n /usr/share/zsh/vendor-completions/_hardball
prints "replay" bash -c '. /usr/share/bash-completion/bash_completion && _completion_loader hardball ||
  COMP_WORDS=(hardball re) COMP_CWORD=1 && _hardball && echo "${COMPREPLY[@]}"'

echo "-- the library"
install g++ cmake make pkg-config
cmake -S consumer -B built >cmake.log && cmake --build built >>cmake.log || { cat cmake.log && false; }
built/consumer
g++ consumer/main.cpp $(pkg-config --cflags --libs hardball) -o consumer.pkg-config
./consumer.pkg-config
gcc -std=c99 game_loop.c $(pkg-config --cflags --libs hardball-c) -o game
prints "$(cat game_loop.txt)" ./game

echo "-- the Python package"
install ./python3-hardball_*.deb
dpkg --verify python3-hardball
prints "$(hardball --version)" python3 -m hardball --version
hash=$(python3 -c "
import hardball
gas = hardball.Simulation.from_scenario(hardball.scenarios() / 'newtons_cradle.toml')
gas.run()
print(gas.event_log_hash)")
prints "$hash" hardball run "$examples/newtons_cradle.toml" --json --quiet
test -d /usr/lib/python3/dist-packages/hardball/__pycache__
prints "polished: True" python3 -c "import hardball; print('polished:', hardball.pack(60, phi='max', polish=True).is_polished)"

echo "-- removal"
apt-get -q -y purge python3-hardball hardball >apt.log
left=$(find /usr /etc /var/lib -path '/var/lib/apt' -prune -o -name '*hardball*' -print)
[[ -z $left ]] || { echo "left behind: $left" && false; }
