# Sourced: a Slurm cluster of two nodes on this machine, as root, in the folder $cluster. Its programs end
# with the shell that starts the cluster.

# Two nodes with a core each: `slurmd -N` simulates several on one machine.
slurm_conf() {
  cat <<CONF
ClusterName=talweg
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
SlurmdUser=root
AuthInfo=socket=$cluster/munge/socket
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/%n.log
ProctrackType=proctrack/pgid
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=10
KillWait=2
MailProg=/bin/true
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName=n1 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=17001 CPUs=1 RealMemory=4000
NodeName=n2 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=17002 CPUs=1 RealMemory=4000
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
}

start_munge() {
  local folder=$cluster/munge
  mkdir -p "$folder"
  dd if=/dev/urandom of="$folder/key" bs=1 count=1024 2>/dev/null
  chmod 600 "$folder/key"
  chown -R munge: "$folder"
  # --force: otherwise munged refuses folders that other users can write into.
  runuser -u munge -- /usr/sbin/munged --force --socket="$folder/socket" \
    --key-file="$folder/key" --pid-file="$folder/pid" --log-file="$folder/log" \
    --seed-file="$folder/seed" 2>/dev/null
}

start_node() { slurmd -N "$1"; }

start_slurm() {
  mkdir -p "$cluster"/{state,n1,n2}
  trap stop_slurm EXIT
  start_munge
  slurm_conf >"$cluster/slurm.conf"
  export SLURM_CONF=$cluster/slurm.conf
  slurmctld
  start_node n1
  start_node n2
  wait_for 30 "two idle nodes" nodes_are_idle
}

nodes_are_idle() { [[ $(sinfo -h -N -t idle -o %N | wc -l) == 2 ]]; }

stop_slurm() {
  scancel --quiet --user=root 2>/dev/null || true
  local file
  for file in "$cluster"/{n1.pid,n2.pid,slurmctld.pid,munge/pid}; do
    pkill -F "$file" 2>/dev/null || true
  done
}

# Simulates a power failure: kills the node's daemon, the daemons of its steps, and all their children.
kill_node() {
  local process
  kill -KILL "$(<"$cluster/$1.pid")"
  for process in $(pgrep slurmstepd); do
    if [[ $(readlink "/proc/$process"/fd/* 2>/dev/null) == *"$cluster/$1.log"* ]]; then
      kill -KILL "$process" || true
    fi
  done
  for process in $(grep -lsz "^SLURMD_NODENAME=$1\$" /proc/[0-9]*/environ | cut -d / -f 3); do
    kill -KILL "$process" 2>/dev/null || true
  done
}

# wait_for SECONDS WHAT COMMAND...: until the command succeeds.
wait_for() {
  local until=$((SECONDS + $1)) what=$2
  shift 2
  until "$@"; do
    ((SECONDS < until)) || fail "no $what within the time"
    sleep 0.1
  done
}

# Whether all tasks of the job have left the queue.
job_is_over() { [[ -z $(squeue -h -j "$1" 2>/dev/null) ]]; }
