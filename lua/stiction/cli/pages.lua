-- Help pages that no schema can tell.
local pages = {}

pages.overview = [[
stiction new NAME         write a study to start from into a folder of your own
stiction run STUDY        run a study's cases, checks and figures
stiction help TOPIC       topics: commands, workers, new, study, results, figure, columns (of probes), units, solve, trade,
                          fit, sample, peers, any part below or any of its kinds
]]

pages.commands = [[
new NAME       write a study to start from into a folder of your own; --list: the examples; 'stiction help new'
run STUDY      run the cases of a study, check them, draw its figures; a folder of studies: all, and one report;
               --ranks N: N processes share each case by MPI (bodies in space on rigid obstacles; needs petsc-dev);
               --join: several runs, also on several machines, share the sweep; --worker, --on slurm: 'stiction help workers'
status STUDY   how far its sweep is: done, running (by which worker, since when, how far), waiting, failed; rate and time left;
               whether workers live; from any machine that sees the output; STUDY may be an output folder
results STUDY  results and checks of what has run, made anew from the histories; no case runs
why STUDY      of each case: reused by the next run, or which value changed from what to what
clean STUDY    remove what no case of the study refers to from its output (--list: only say what)
figures STUDY  draw the figures again from the output
show STUDY     the cases that an output holds: --where 'mu > 0.3 and verdict == "finished"' (SI), --sort -NAME,
               --columns a,b, --csv FILE, --h5 FILE (a table 'cases', SI), --sheet FILE (a field of every case, PNG);
               --case ID --animate FILE.ogv: a field (--field) of one case over its time, --frames N of it, --rate N a second;
               STUDY may be an output folder; nothing is run
report STUDY   one page (HTML) that needs nothing else: question, parameters with reasons, results with units and what they
               may be off by, checks, figures, warnings and remarks, what was modelled, versions; also of an output folder
verify OUT     compute its cases again (all, or --sample N) from the source that is kept with them, and compare results and
               histories with what is kept: to the last bit, or results within --tolerance if another build or processor made
               them; summary.csv too, fields are not compared; OUT: also an archive, of which all files are held against its list
pack OUT       one archive (.tar.gz) of an output with its description as a Workflow Run RO-Crate, which verify accepts
compare A B    two outputs (folders or studies): the parameters, settings and results that differ, and by how much
trade STUDY    what accuracy costs: a ladder of settings, errors against work; 'stiction help trade'
fit STUDY      parameters from measured curves, with intervals, what the simulation itself may be off by, and a verdict; 'stiction
               help fit'
sample STUDY   spread, quantiles and shares of the variance of results under uncertain parameters; 'stiction help sample'
explain STUDY  what a study asks, models and costs, and what to change, before anything runs
solve FILE     solve a saved contact problem again, with any solver, and say where there is no single answer
bench [STUDY]  time one case, phase by phase, beside what it cannot do without
peers [CASE]   run cases that other programs have run, side by side with them; 'stiction help peers'
extremes       drive small scenes to extremes; a map of how each ends
help [TOPIC]   this help; help --html DIR: all of it as one page to search
test [--all]   build and run the tests

STUDY is a folder with study.lua, or a .lua file. 'stiction COMMAND --help' lists the options.
Exit codes: 0 all held; 1 a case failed, a check did not hold, or the run was stopped; 2 bad input.
Output of run, below out/<study> or --out DIR: summary.csv, checks.json, figures.json, figures/, and a
folder per case with series.h5, manifest.json, fields.pvd and fields/, steps.csv; source/: the files read. A case without
fields (output.frames = 0) that runs as it should leaves two files: series.h5 and manifest.json.

steps.csv has a row for every step with contact problems (without fields: where more than one method answered them),
and for every cut and growth of the step with its reason;
its column `contact` counts what answered the problems of that attempt ("sweeps 3 newton 1"), as that of summary.csv
does for a whole case. The newton solver, the default, tries in this order: sweeps (Gauss-Seidel with Anderson's
mixing; many points without bonds), newton, proximal (the proximal point method), uphill (newton from no forces and
from those with which all points stick, on two maps, also where the residual rises); without friction descent and
minimisation of the potential; with it pivoting (Lemke's method), damping (bonds that snap: bodies in a viscous medium,
less and less of it), uzawa, gauss_seidel (plain sweeps) and enumeration (every status of every point). Fewer than 60
rows, or points with bonds, are newton's first; proximal and uphill are then tried late, without bonds, and where all
that fails proximal comes again, each problem on its way answered by all of this. none: nothing did.

A remark at the end of a case (also in its manifest.json) tells where theory promises no single
answer to a step: W_nn <= mu |W_nt| at a point that presses (a rod jams: Painleve), or 1/W_nn <= the steepest fall
of a pulled bond's force (bonds snap; RCC without viscosity: 3 C beta^2 A). Each kind is told once, at its first step,
with the number of steps, and with the answers to that step that were found from other starts; of up to five dry points
in the plane all statuses are tried, so that it is sure that there are no others. W: the displacements of a contact
point for unit forces on it. In dynamics a remark also tells when the time steps made more than 1 % of the largest
energy of the run, or lost more than 10 %. Of a pair of which nothing touched or adhered in the whole run it tells that,
and how near its points came.]]

pages.workers = [[
stiction run STUDY --worker                  # a worker: cases that no other run has, one at a time (--jobs N), until none is left
stiction run STUDY --on slurm --workers 64 --time 12:00:00 --partition long      # one job array of 64 such workers
stiction status STUDY                        # how far all that is, from anywhere

A worker takes one thread a case; --threads N gives it more, and as many cores of each Slurm task as --jobs times that.
Workers need nothing but an output folder (--out DIR, the same for all) that they all see, and this program. Start any
number, at any time, with whatever starts processes; all take the same --set, --quick, --where:

  for host in a b c; do ssh $host "cd $PWD && stiction run STUDY --worker --jobs 16" & done; wait
  parallel --jobs 16 --sshlogin a,b,c --workdir . -N0 'stiction run STUDY --worker' ::: $(seq 48)
  hq submit --array 1-48 stiction run STUDY --worker

Each case is done once. A worker that finds none to begin leaves; one of them stays for the last ones that others run,
takes them over if those die, and judges and draws the whole sweep. Who is killed loses nothing but the case that it ran:
another worker does it, at once on the same machine, after a minute without a sign of life elsewhere. Clocks of machines
are not compared. On SIGTERM a worker stops its case and gives it back. Where nothing can be written (a full disk, a
quota) a worker ends without failing the case.

--on slurm validates the cases, writes <out>/slurm/worker.sh, submits it once with sbatch (--requeue, --signal=B:TERM@60: SIGTERM
a minute before the time limit), prints the job's id and returns. --workers: default 16, never more than cases; sites
limit arrays to about a thousand tasks. --sbatch OPTION passes a further option on (--sbatch=--mem=4G
--sbatch=--account=x). --ranks N asks for N tasks each, which share a case. The same command submits
further workers, if time limits ended them before the sweep.
Exit codes: 0 submitted, or nothing to do; 2 bad input, no sbatch, or its refusal, in its own words.]]

pages.new = [[
Usage: stiction new NAME [--from EXAMPLE] [--list]

Writes a study that runs into the folder NAME (a path, if need be), which must not exist or be empty, and says what to do
next. Without --from it is a short one with comments: a block pressed onto a plane and pulled off, for two energies of the
bonds, with a probe, a figure and a check. With --from EXAMPLE it is a copy of that example, with its mesh.
--list: the examples with their titles; they are explained in studies/examples/README.md.
Exit codes: 0 written or listed; 2 bad name, unknown example, or a folder that holds something or cannot be written.]]

pages.units = [[
local units = stiction.units; local mm, ms = units.mm, units.ms
5*mm, 20*units.J/units.m^2 and 20*units("J/m^2") are quantities: arithmetic checks their dimensions, a
quotient of like quantities is a plain number. q:to("mm") gives the plain number, q:abs() the magnitude.
]]

pages.study = [[
local stiction = require "stiction"
local mm, s = stiction.units.mm, stiction.units.s

return stiction.study {
  title = "What it is", question = "What it asks",
  given = { radius = 5*mm },                          -- stated by the source
  chosen = { step = {0.01*s, "halving it changes nothing"} },   -- ours, each with its reason
  sweep = { mu = {0, 0.2} },                          -- all combinations; or {{"v", {...}}, {"mu", {...}}} to fix
                                                      -- the order; or a list of cases {{mu = 0}, {mu = 0.2}};
                                                      -- stiction.sample.zip, latin_hypercube, sobol draw lists
  case_id = function(p) return "..." end,             -- optional; else like mu0.2
  scene = function(p) return stiction.scene{ ... } end,         -- p: all values above by name; or in its place
                                                      -- problem = function(p) return {file = "...h5"} end
  results = {                                         -- by name, or a list of {name = ..., ...} to fix the order
    peak = { unit = "Pa", meaning = "Largest pressure",
      function(run, p) return run:max("crown", "pressure") end },
  },
  quick = { sweep = {mu = {0}}, set = {step = 0.1*s} },         -- what --quick changes
  check = function(cases, check)
    check.close("peak at mu 0", cases:find{mu = 0}.results.peak, 30e3, 0.02)
  end,
  figures = function(cases) return { stiction.figure.lines{ ... } } end,
}

run:  id, p, time (list, s); series(group, name, component) -> list, unit; max(group, name) and min -> value,
      time; at(time, group, name). All numbers SI. stiction.numeric: max, min, extreme, argmax, argmin,
      interpolate(xs, ys, x), first_where(list, test, start), integral(xs, ys), map(list, f).
      Of a saved contact problem (problem: file relative to the study, solver = "all", tolerance = 1e-8): contacts,
      components, doubts, free, and for each solver a table like run.newton: converged, method, iterations, work (in
      products W p), residual, relative, cone_error (Siconos' measure; of dry problems with fixed mu), seconds, force,
      displacement. output{problems_every = n} saves such files.
cases: a list; cases:find{mu = 0} (nil if absent), cases:where{...}, cases:values("peak"), cases.quick;
      each case is a run with results by name.
check: equal(name, value, expected, tolerance), close(name, value, expected, relative), within(name, value,
      low, high), holds(name, flag), non_decreasing(name, list, tolerance), non_increasing, increasing(name, list).
       proof{case =, quantity =, unit =, kind = "exact" | "published" | "ours", source =, reference =,
       values = {{resolution, value}, ... finest last}, resolution = "cell/m", tolerance = (relative to scale, default
       |reference|), scale =, order = (least observed), run = case, note =}: a row of the report that running a
       folder of studies writes. stiction.reference holds closed solutions.
       ledger(case, tolerance): energies sum up to 1e-6 of the largest (probe.energy{audit = true});
       table{title =, columns = {...}, rows = {{"key", ...}, ...}}: into the report, joined by title and key.
stiction.schemes: names(), make(name), about(name): the time schemes that studies compare.
stiction.csv "FILE" or {file =, units =}: columns of measured values by name, as lists of quantities.
stiction.relaxation.fit{frequency =, storage =, loss =}: rest, terms (a body's `relaxing`), error, worst.
figure: lines{...}, field{...}, panel{...}, map{...}: 'stiction help figure'.]]

pages.figure = [[
figures = function(cases) return { stiction.figure.lines{ ... }, ... } end,      -- a key of a study

Each becomes figures/NAME.png in the output folder, anew with 'stiction figures STUDY'. Plain numbers are SI; quantities
may stand wherever numbers have units. Where a case is given, "probe/column" names one of its histories ('stiction help
columns' lists them). cases: as in results and checks; a loop over them makes a curve of each:

  local curves = {}
  for i, case in ipairs(cases) do
    curves[i] = { label = "mu = " .. case.p.mu, case = case, y = "top/force_y" }
  end
  return { stiction.figure.lines { name = "force", x = { label = "time", unit = "ms" },
    y = { label = "force", unit = "N/m" }, curves = curves } }

Measured values beside them: stiction.csv "pull.csv" reads a file in the study's folder whose head is like
"time [ms],force [N/m],scatter [N/m]"; units = { force = "N/m" } says what its head does not:

  local pull = stiction.csv "pull.csv"                -- or { file = "pull.csv", units = { ... } }
  curves[#curves + 1] = { label = "measured", x = pull.time, y = pull.force, error = pull.scatter, style = "points" }]]

pages.results = [[
results = {                                           -- a key of a study
  peak = { unit = "Pa", meaning = "Largest pressure", function(run, p) return run:max("crown", "pressure") end },
}

The function gives a number in SI or a quantity; it stands in summary.csv in SI and on the screen in `unit`.
run.id, run.p            name and parameters of the case
run.time                 list of the times of its steps, s
run:series(probe, column [, component])    list of values at those times, and the unit; component: of a column that has
                         several values, as those of contact_line: one per point, from 1
run:max(probe, column [, component])       largest value and its time; run:min likewise
run:at(time, probe, column [, component])  value at a time, between steps on a straight line; past the end what it is there
run:last(probe, column [, component])      value at the end
run:derivative(parameter, function(run) ... end)   derivative of what that gives; 'stiction help derivatives'
run:columns()            names "probe/column" of all there is; 'stiction help columns' says what they are
run.cost                 counters of the run: seconds, cpu_seconds, steps, iterations, work, unknowns, peak_memory,
                         seconds_in_assembly (and _factorization, _solve, _contact, _output: processor time) ...
It is run:max(...), with a colon. stiction.numeric works on lists: max, min, extreme, argmax, argmin, interpolate(xs, ys,
x), first_where(list, test, start), integral(xs, ys), mean(list), amplitude(list), map(list, f).
Results are computed when a case ends; a changed function needs 'stiction run STUDY' once more.]]

pages.derivatives = [[
derivatives = { "mu", "w", "young" },                 -- a key of a study: names of its parameters

Beside every case there is then a run for each of these, in which the parameter is smaller by a hundred-thousandth of itself. It makes
the case's own steps, each corrected with the case's own factor from the case's own forces: no matrix is made or factored for it. Its
histories are below <case>/derivatives/<parameter>; summary.csv has d_<result>_d_<parameter> of every result, in SI, and
  run:derivative("mu", function(run) return run:max("sole", "force_x") end)    is the derivative of any number, quantity or list
  run:beside("mu")                                                             that run, and by how much mu is different there, SI
They are exact to some five digits, less of a parameter that does little: 1e-12 to 1e-9 of the largest force is left undone, over 1e-5 of
the parameter. Where results jump, or a point turns from sticking to slipping within so small a change, what is told
is the change itself. How many steps ended with a point whose status is another stands in the manifest (result.beside: turned); a run
that cannot follow any more ends, is told, and its derivatives are nan. The case's own steps then end with a factor of where they end.
'stiction fit' takes them for its parameters and needs no cases for derivatives, 'stiction sample' for its polynomial. There are none
with explicit schemes, steps chosen by their error, meshes made anew and half spaces, nor with respect to what changes the mesh, the
schedule's times, what is driven, which pairs or which formula there are: that is refused. A parameter that is 0 has none, which is told.
Where bonds snap one after another (b = 0, and stiff beside what a point gives way: `run` warns) derivatives are those between two snaps,
with the edge of contact where it is, not of the curve that the snaps follow: take differences there, over several snaps.
Six of them beside the paper's sliding plate take 15 to 19 % of the case each, one alone 36 to 60 %, as factors of where steps end are made
for all of them together; those may take more than the case itself of a block in space whose factor would have served for several steps.]]

pages.solve = [[
stiction solve FILE [--with SOLVER] [--tolerance NUMBER] [--json]

FILE is a contact problem in HDF5: a run that fails to converge leaves problems/failed.h5 in its case's folder;
output{problems_every = n} in a scene, or 'stiction run STUDY --problems n', saves that of every n-th step there. It is
solved by SOLVER ('stiction help solver' lists them; default: all in turn) to a relative natural-map residual (default
1e-10), from no forces. That is the largest of all points, over the largest traction; of dry problems with fixed mu Siconos'
measure stands beside it, |r - P(r - (u + mu |u_t| n))| / |q| over all points, in units in which the mean diagonal of W and the
largest component of q are 1. Each line tells whether the solver converged, by which method ('stiction help commands' lists
them), its iterations and the residual, which is judged apart from all solvers; below stands where theory promises no
single answer at a point that presses or is pulled ('stiction help commands' on remarks), and which solvers answer
differently. --json gives all that, with free gaps and slips, forces and displacements, contact by contact (n, t1, t2).
Exit code 0: all converged; 1: one did not; 2: no such file or solver. A study may do the same in place of a scene:
problem = function(p) return { file = "...h5", solver = "newton", tolerance = 1e-8 } end.]]

pages.peers = [[
stiction peers [CASE...] [--size SIZE] [--quick] [--stored] [--turns N] [--problems DIR] [--out DIR]

Runs the cases of studies/peers as a user would and the same cases in GetFEM, CalculiX or Siconos (Debian packages; scripts
for /usr/bin/python3), pair by pair and in turns, each side in a process with one thread, and prints two tables: processor
time, peak memory, unknowns, iterations, and the ratio of the times, peer over Stiction; and results with their difference.
They also stand in peers.json and peers.csv below out/peers or --out. A peer that is missing is named with its package; then,
or with --stored, results are compared with what it gave when the case was written down, and no time is. Each quantity has a
largest difference that is allowed; the exit code is 1 if one is above it, or if Stiction has no answer.

block3d    an elastic block pressed onto a plane and dragged, in space (GetFEM, CalculiX)
slide2d    a rubber plate drawn across a half disc, in plane strain (GetFEM, CalculiX)
friction   Coulomb problems W, q, mu alone, to 1e-8 of Siconos' measure, by the default solver (the best of Siconos' for each)

--size: all up to small (seconds; --quick), medium (minutes; the default), large or largest (hours). --turns N takes medians.
--problems DIR takes the friction problems from there; those of the size largest stand nowhere else.]]

pages.trade = [[
trade = {                                             -- a key of a study
  quantities = {
    "peak",                                           -- a result
    { name = "force", scale = 1*N },                  -- what its error is relative to (default: the reference itself)
    { name = "rebound", reference = 1 },              -- known exactly: a number, a quantity or function(p)
    { name = "crown", series = "probe/column" },      -- a curve: a history over time ...
    { name = "profile", curve = function(case, p) return xs, ys end,    -- ... or any; xs rising
      reference = function(x, p) return y end },      -- and, if it is known, what it should be
  },
  knobs = {                                           -- parameters of the study, by name; the value in force is a level
    { "mesh_size", { 1*mm, 0.5*mm, 0.25*mm }, label = "h" },  -- numbers rise or fall towards the finest; label: its
                                                      -- short name in figures
    { "scheme", { "default", "massless" } },          -- words and flags are choices
  },
  set = { mu = 0.4 },                                 -- one value for everything swept
  combinations = 6,                                   -- of knobs, run after each knob alone, and as many neighbours of
                                                      -- the front so far (default 6)
  quick = { knobs = {...}, set = {...} },             -- what --quick puts in their place
}

'stiction trade STUDY' runs the default settings, each knob alone, all numbers at their finest, then the combinations
that promise most and those next to the front with one number coarser, and writes trade.csv, trade.json and figures
below out/<study>/trade (a count whose name a knob or result has is NAME_counted there). The reference of a quantity is
the finest run, corrected knob by knob by Richardson extrapolation (orders 0.7 to 4; half of the correction is its
uncertainty; above the order 2.2, and where the first of the last three levels is off by a quarter, the last difference
if that is more, unless a level more confirms the order; where no such order shows, there is no correction, and the
uncertainty is the larger of the last two differences, one and a half times what an order below 0.7 leaves, and what the
order 0.4 does where differences do not fall; where three in a row do not, or where a finer number leaves a quantity
exactly as it is while it moves others, as a time of the grid, its uncertainty is not known, and --accuracy promises
nothing of it; what the finest run may lack between its steps at an extreme of run:max or run:min, or as an instant, is
added). That of a curve is the finest run's, uncorrected; its error is the L2 norm of the
difference over the norm of the reference (or over scale * sqrt(length)), all curves brought to the abscissas of the one
with most points and linear between them. Where a reference is given, it has no uncertainty.
Error: the largest over the quantities. Bound: error and uncertainty of the reference. Work: counted floating-point
operations, the same on every machine. Settings that no other beat in both error and work, by a hundredth of the error
at least, are the front.

The full form is kept beside the study (trade.json) for 'stiction run STUDY --accuracy 2%', which takes the cheapest
measured settings whose bound is within 2 % (with --of NAMES, of these results or curves alone; else of all quantities)
and adds to summary.csv what each result may be off by (NAME_error, in the result's unit; of a curve relative to its
norm). That is claimed of the scene that was measured alone, that of study.trade.set in all its parameters; it is checked
to give each number within its error of what it was then. For any other scene the settings are a guess: the run says so
and its error columns stay empty.

'stiction run STUDY --check-accuracy' (alone, or with --accuracy) measures what is not known: each case again with each
number of the knobs a level finer, one at a time, and with the default in place of each other choice. The claim is the
sum of what these change, of a number times 1 / (1 - r^-0.4) where its resolution falls by r (4.1 for a half), as if
errors fell with the order 0.4: mostly they fall faster, but of 46 changed scenes (studies/trade/claims) 8 were off by
more than first order says, 1 by more than this, and half of the claims are more than four times the error. A millionth
of the value is added for the solvers' tolerances, and to what run:max and run:min give also how far the history may go
between two steps there, which finer steps at the same instants do not show, to an instant of the run its step. Of a
result that a finer number leaves exactly as it is, while it moves others, nothing is claimed: it may take steps, as a
time of the grid or an area in cells does. With --accuracy it is a check that the claim is within the share.
The finer runs are kept below finer/ in the output.]]

pages.fit = [[
fit = {                                               -- a key of a study
  parameters = {                                      -- of the study, by name: from, to
    w = { 0.1*J/m^2, 10*J/m^2, scale = "log" },       -- scale: "linear" (default) or "log"
    mu = { 0, 1, start = 0.3 },                       -- start: default the study's own value
  },
  data = {                                            -- measured curves, by name
    slow = { file = "slow.csv",                       -- comma-separated, from the study's folder on
      x = "height", y = "pull",                       -- its columns, "height [um]" in the head or units = { height = "um" }; x rises
      sigma = 0.2*mN,                                 -- standard error of y, or the column that has it; relative = 0.05 as well
      correlation = 5*um,                             -- of the noise along x, exp(-|x - x'| / 5 um); or "estimated" from the residuals;
                                                      -- white = 0.1*mN: what each point has for itself beside that. Any other noise:
                                                      -- covariance = { file = "table.csv", unit = "mN^2" }, in place of them
      case = { speed = 1*mm/s },                      -- what this curve's case has, beside the fit's parameters
      against = function(run, p) return xs, ys end,   -- the same of a run, SI; one way of x. Or { x = "probe/column", y =
                                                      -- "probe/column" or "time", x_sign = -1, y_sign = -1, after = 1*s, before = 2*s }
      own = { zero = { -5*um, 5*um } },               -- parameters of this curve alone; a name that the study does not have is
                                                      -- there for `against` as p.zero, and costs no cases
      weight = 1 },                                   -- how often its squares count; chi square, errors and intervals know of it
    rate = { file = "rate.csv", x = "speed", y = "pull_off", sigma = "scatter", each = { speed = "speed" },
      against = function(run, p) return number end }, -- each: a case a row, its parameters by column
  },
  loss = "squares",                                   -- or "huber", "soft", "cauchy" against outliers
  starts = 1,                                         -- 8: further ones by Sobol's points between the bounds
  finer = { cell = 0.02*mm },                         -- settings a level finer; default: those of the study's trade
  further = { speed = { 2*mm/s, 20*mm/s } },          -- measurements thought of, of the first curve with another value
  noise = 1e-6, profiles = true, most = 180,          -- relative noise of runs (default: measured), intervals by profiles,
                                                      -- evaluations of the search at most (60 a parameter), a batch begun is ended
  quick = { profiles = false },                       -- what --quick puts in their place
}

'stiction fit STUDY' looks for least squares of (model - data) / sigma by Levenberg and Marquardt's steps (GSL). An evaluation is one
case a curve, kept below out/<study>/fit by its values: a fit that was killed goes on where it was, one with other data, bounds or
curves takes what there is. Derivatives are differences, a batch of cases, whose size comes from how rough the runs are (third
differences of four runs); between batches they are brought along. Over parameters that the study names in `derivatives` they come
with each case ('stiction help derivatives'). Where a case fails the step was too long. It ends within a fifth
of a standard error, the same to the last bit whatever --jobs is.

Errors that are not given are those that the residuals show; where some curves have them, those of the others are told by third
differences along them. Noise that goes on from point to point (drift, a filter) tells less than independent noise: `correlation` is its
length in x, for residuals that are each freed from what they share with those before; chi square, runs and intervals are of these,
and it is told how many independent points a curve's are worth. An estimated length is the likeliest (restricted: parameters may
follow); above half of the curve it cannot be told from a wrong model, which is then rejected. The 95 % intervals are by profile
likelihood (--no-profiles: by the covariance): the other parameters are at their best at each point of it, until they would gain less
than 0.01 of a squared standard error; where cases fail or they do not settle the end is open and that is said ("not followed"). They
are widened by what one finer level changes, times what claims of a trade allow for ('stiction help trade'): less than the simulation's
own error is
never claimed. A parameter that ends at a bound has no standard error, but the end of its interval on the other side, by its profile.
One counts as determined up to a standard error of 25 % of itself (a linear one: of at least a tenth of its range); only in combination
if it would be so with the others known, and the product of powers that is determined, of linear parameters the sum ("zero - 2.5 um/mN
* load"), is told; else not. The model is rejected where chi square, or the runs of like signs among residuals, have a chance below
0.001, unless one finer level changes the curves by as much. Where it is so with errors that are known (least squares) standard errors,
intervals and combinations are all widened by the root of chi square per degree of freedom, which is told, and verdicts are by these.
Exit code 1: rejected. It leaves fit.json (all in SI), fit.csv (evaluations), curves.csv (data, model, residuals) and figures;
'stiction report' makes one page. A parameter that changes the mesh is refused.]]

pages.sample = [[
sample = {                                            -- a key of a study
  of = { mu = { uniform = { 0.1, 0.5 } },             -- uncertain parameters: uniform, log_uniform (low, high), normal (mean, standard
    w = { log_normal = { 1*J/m^2, 0.2 } } },          -- deviation), log_normal (median, standard deviation of the logarithm)
  fit = true,                                         -- in their place or beside them: parameters of the study's fit (of the same
                                                      -- --out), which depend on each other; or the path of a fit.json; or { curve =
                                                      -- "slow", file = "fit.json" }: with the own parameters of that curve; what
                                                      -- `of` and `set` name is as they say, what is at a bound is held there
  list = { { mu = 0.1, w = ... }, ... },              -- alone: one's own points, or a .csv file with a column for each
  design = "sobol",                                   -- or "latin_hypercube"; "saltelli": pairs of points, count * (parameters + 2)
  count = 64, seed = 1,                               -- --count N, at most 100000: more keep the points (a hypercube: 2 N)
  results = { "pull_off" },                           -- default: all
  set = { speed = 1*mm/s },                           -- one value for what the study sweeps
  quick = { count = 16 },
}

'stiction sample STUDY' runs the points, kept below out/<study>/sample, and tells of each result mean and standard deviation with their
sampling error (as of independent points, more than Sobol's need), quantiles with intervals by order statistics, and whose its
variance is: first (a parameter alone) and total (with all others) Sobol indices, of saltelli's pairs with errors by resampling, else
of a polynomial (chaos expansion) whose error at points left out is told: above some 10 % believe the pairs. A "-" stands where there is
nothing to tell: of shares where a result does not vary (beyond rounding), of the polynomial where there are too few points for one of
first degree (1.5 a term) or the points are a list, of all where fewer than two cases give the result. Of a fit's parameters there are no
shares, as they depend on each other; those that its `against` alone reads, such as an offset of the measured height, are left out, as
no case and no result has them. The count is limited because each point is a case with a folder of its own, which stays: 100000 cases
at most, so that saltelli's counts end at 100000 / (parameters + 2). Where the study names the uncertain parameters in its
`derivatives` slopes make the polynomial, too, of several times fewer points. Failed cases are listed, with the parameters along which
they lie; the numbers are then of the others alone. Exit code 1: a case failed. It leaves sample.json,
sample.csv and figures; 'stiction report' makes one page.]]

--- What parameters do to a result, told with the kind that has them.
pages.notes = {
  rcc = [[
    b is the time that a bond takes: untouched in contact it grows as beta = w t / b, whole after b / w. Pulled at a
    speed V it lasts longer than its strength: the peak of the traction is 1 % above sqrt(w C) where V b / (w u0) is 0.1
    and 11 % where it is 1 (u0 = sqrt(w / C)), and the work of separation rises with it. b = 0 is the law without rate:
    a point that closes has a whole bond in that very step, as often as it closes; pulled beyond u0 the bond is
    beta = w / (C u^2) at once. Lifted beyond 20 u0, where 1/400 of it is left, it is torn: the point forgets where it was
    bonded, and may bond anew at any other place. Such bonds snap where the bodies are softer than they (explain tells): a quasi-static
    run may then need a small b.
    bonding says where beta may grow. contact: where the point is closed, so pressing time decides what has to be broken
    later. proximity: at any distance at which the law says so, C u^2 beta < w: what is near pulls with w^2 / (C u^3),
    up to 20 u0 before it ever touched, and a bond that was torn heals; what slides meanwhile stretches such bonds, so give
    surfaces that meet aslant a small C_t. never: it only falls from beta0, as glue that was there at the start; with
    beta0 = 0 nothing ever sticks.]],
  theta_xi = [[
    theta = 1/2 keeps the energy of what swings inside the bodies, theta > 1/2 takes some of it at each step, of short
    waves first: an impact of a bar on 100 cells loses 6 % with 0.55 and 18 % with 1 (backward Euler; xi = 1 goes with
    it), and smaller steps lose less. In slow motions all theta agree. xi weighs the forces likewise; leave it equal to
    theta.]],
}

return pages
