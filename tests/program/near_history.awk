# Two history.csv: the same steps and counts, every other column to 1e-8 of its
# largest value. Energies (J), which add up errors, to 1e-6, and
# several_solutions_ratio, which depends on slopes of the friction law, to `ratio`.
# What vanishes but for rounding: energies to 1e-12 of the largest one, forces (N)
# and moments (Nm) to 1e-12 of the load (times 1 m). Velocities (m/s), differences of
# displacements over a step, to 1e-9 of the approach over the step. In the second
# file an energy_balance_error of at most `balance`.
function size(x) { return x < 0 ? -x : x + 0 }
function complain(text) {
  print text
  failed = 1
}
FNR == 1 {
  for (i = 1; i <= NF; ++i) name[i] = $i
  if (NR > 1 && NF != n) complain("other columns")
  n = NF
  next
}
NR == FNR {
  rows = FNR
  for (i = 1; i <= n; ++i) {
    known[FNR, i] = $i
    if (size($i) > largest[i]) largest[i] = size($i)
    if (name[i] ~ /_J$/ && size($i) > energy) energy = size($i)
    if (name[i] == "normal_force_N" && size($i) > load) load = size($i)
    if (name[i] == "approach_m" && size($i) > approach) approach = size($i)
    if (name[i] == "time_s" && FNR == 2) step = size($i)
  }
  next
}
{
  others = FNR
  for (i = 1; i <= n; ++i)
    if (name[i] ~ /^(step|nodes_|impacts|parts)/) {
      if ($i != known[FNR, i])
        complain("row " FNR ": " name[i] " is " $i ", not " known[FNR, i])
    } else if (name[i] == "energy_balance_error") {
      if (!(size($i) <= balance)) complain("row " FNR ": " name[i] " " $i)
    } else if (name[i] != "iterations" &&
               size($i - known[FNR, i]) > worst[i])
      worst[i] = size($i - known[FNR, i])
}
END {
  for (i = 1; i <= n; ++i) {
    is_energy = name[i] ~ /_J$/
    floor = is_energy ? 1e-12 * energy : name[i] ~ /_Nm?$/ ? 1e-12 * load : 0
    if (name[i] ~ /^velocity_/ && step > 0) floor = 1e-9 * approach / step
    near = is_energy ? 1e-6 : name[i] == "several_solutions_ratio" ? ratio : 1e-8
    if (worst[i] > near * largest[i] && worst[i] > floor)
      complain(name[i] " differs by " worst[i])
  }
  if (rows < 2 || rows != others) complain("not " rows - 1 " rows")
  exit failed
}
