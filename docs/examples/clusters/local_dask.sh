#!/bin/sh
# A Dask cluster on this machine, one command on it, and its end.
#
#   sh local_dask.sh procc-annotator calibrate match/ fitted/ --resume
#
# Workers have one thread each: the work is Python's, and threads of one process wait for each other.
# Tried on Debian 12 with Python 3.11 and dask 2026: cameras and tables are those of a run without a
# cluster, byte by byte; a worker that was killed, and a command that was killed and went on.
set -eu
: "${WORKERS:=2}" "${PORT:=8786}" "${MEMORY:=2GB}"
bin=$(dirname "$(command -v procc-annotator)") # the scheduler has to be of the same environment
"$bin/dask" scheduler --host 127.0.0.1 --port "$PORT" --no-dashboard >scheduler.log 2>&1 &
scheduler=$!
"$bin/dask" worker "tcp://127.0.0.1:$PORT" --nworkers "$WORKERS" --nthreads 1 \
    --memory-limit "$MEMORY" --no-dashboard >worker.log 2>&1 &
worker=$!
trap 'kill "$worker" "$scheduler" 2>/dev/null || true; wait 2>/dev/null || true' EXIT INT TERM
"$@" --dask "tcp://127.0.0.1:$PORT"
