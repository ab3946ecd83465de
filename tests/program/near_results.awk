# Two results.csv: the same meshes and counts, N to 1e-8, T to 1e-8 of mu N; in
# the second a natural residual of at most 1e-10 after at most 12 corrections.
function near(column, scale, difference) {
  difference = $at[column] - known[FNR, column]
  if (difference < 0) difference = -difference
  if (!(difference <= 1e-8 * scale)) complain(column " differs by " difference)
}
function at_most(column, limit) {
  if (!($at[column] + 0 <= limit)) complain(column " is " $at[column])
}
function complain(text) {
  print "row " FNR ": " text
  failed = 1
}
BEGIN {
  n_exact = split("level dofs contact_nodes elements_across slip_operator " \
    "creepage_x creepage_y spin_1/m nodes_in_contact converged", exact, " ")
}
function without_quoted_commas(part, n, i) { # of names of solvers
  n = split($0, part, "\"")
  for (i = 2; i <= n; i += 2) gsub(",", ";", part[i])
  $0 = part[1]
  for (i = 2; i <= n; ++i) $0 = $0 part[i]
}
FNR == 1 {
  delete at
  for (i = 1; i <= NF; ++i) at[$i] = i
  if (!("corrections" in at)) complain("no corrections")
  next
}
{ without_quoted_commas() }
NR == FNR {
  rows = FNR
  for (column in at) known[FNR, column] = $at[column]
  next
}
{
  others = FNR
  for (i = 1; i <= n_exact; ++i)
    if ($at[exact[i]] != known[FNR, exact[i]])
      complain(exact[i] " is " $at[exact[i]] ", not " known[FNR, exact[i]])
  load = known[FNR, "normal_force_N"]
  if (!(load > 0)) complain("no load")
  near("normal_force_N", load)
  near("force_x_N", mu * load)
  near("force_y_N", mu * load)
  near("spin_moment_Nm", mu * load * known[FNR, "half_width_x_m"])
  near("approach_m", known[FNR, "approach_m"])
  at_most("residual_normal", 1e-10)
  at_most("residual_tangential", 1e-10)
  at_most("corrections", 12)
}
END {
  if (rows < 2 || rows != others) complain("not " rows - 1 " rows")
  exit failed
}
