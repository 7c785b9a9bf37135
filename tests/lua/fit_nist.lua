-- NIST's nonlinear regression problems from both of their starts: certified values and standard errors.
-- Data, starts and certified values: NIST Statistical Reference Datasets, nonlinear regression (www.itl.nist.gov/div898/strd),
-- as they stand in GSL's tests (multifit_nlinear/test_*.c) and on its pages.
local test, equal = ...
local plain = require "stiction.fit.plain"

local exp = math.exp

local function rational(b, x)
  return (b[1] + x * (b[2] + x * (b[3] + x * b[4]))) / (1 + x * (b[5] + x * (b[6] + x * b[7])))
end

local function counted(first, last, by)
  local list = {}
  for x = first, last, by do
    list[#list + 1] = x
  end
  return list
end

local problems = {
  Misra1a = { x = { 77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0 },
    y = { 10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78 },
    f = function(b, x) return b[1] * (1 - exp(-b[2] * x)) end, starts = { { 500, 0.0001 }, { 250, 0.0005 } },
    best = { 2.3894212918E+02, 5.5015643181E-04 }, errors = { 2.7070075241E+00, 7.2668688436E-06 }, squares = 1.2455138894E-01 },
  BoxBOD = { x = { 1, 2, 3, 5, 7, 10 }, y = { 109, 149, 149, 191, 213, 224 },
    f = function(b, x) return b[1] * (1 - exp(-b[2] * x)) end, starts = { { 1, 1 }, { 100, 0.75 } },
    best = { 2.1380940889E+02, 5.4723748542E-01 }, errors = { 1.2354515176E+01, 1.0455993237E-01 }, squares = 1.1680088766E+03,
    bounds = { { 1, 1e4 }, { 0.01, 10 } } },
  Rat42 = { x = { 9, 14, 21, 28, 42, 57, 63, 70, 79 }, y = { 8.930, 10.800, 18.590, 22.330, 39.350, 56.110, 61.730, 64.620, 67.080 },
    f = function(b, x) return b[1] / (1 + exp(b[2] - b[3] * x)) end, starts = { { 100, 1, 0.1 }, { 75, 2.5, 0.07 } },
    best = { 7.2462237576E+01, 2.6180768402E+00, 6.7359200066E-02 },
    errors = { 1.7340283401E+00, 8.8295217536E-02, 3.4465663377E-03 }, squares = 8.0565229338E+00 },
  Rat43 = { x = counted(1, 15, 1), y = { 16.08, 33.83, 65.80, 97.20, 191.55, 326.20, 386.87, 520.53, 590.03, 651.92, 724.93, 699.56,
    689.96, 637.56, 717.41 },
    f = function(b, x) return b[1] / (1 + exp(b[2] - b[3] * x)) ^ (1 / b[4]) end, starts = { { 100, 10, 1, 1 }, { 700, 5, 0.75, 1.3 } },
    best = { 6.9964151270E+02, 5.2771253025E+00, 7.5962938329E-01, 1.2792483859E+00 },
    errors = { 1.6302297817E+01, 2.0828735829E+00, 1.9566123451E-01, 6.8761936385E-01 }, squares = 8.7864049080E+03 },
  Thurber = { x = { -3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481, -2.363, -2.322, -1.501, -1.460,
    -1.274, -1.212, -1.100, -1.046, -0.915, -0.714, -0.566, -0.545, -0.400, -0.309, -0.109, -0.103, 0.010, 0.119, 0.377, 0.790, 0.963,
    1.006, 1.115, 1.572, 1.841, 2.047, 2.200 },
    y = { 80.574, 84.248, 87.264, 87.195, 89.076, 89.608, 89.868, 90.101, 92.405, 95.854, 100.696, 101.060, 401.672, 390.724, 567.534,
    635.316, 733.054, 759.087, 894.206, 990.785, 1090.109, 1080.914, 1122.643, 1178.351, 1260.531, 1273.514, 1288.339, 1327.543,
    1353.863, 1414.509, 1425.208, 1421.384, 1442.962, 1464.350, 1468.705, 1447.894, 1457.628 },
    f = rational, starts = { { 1000, 1000, 400, 40, 0.7, 0.3, 0.03 }, { 1300, 1500, 500, 75, 1, 0.4, 0.05 } },
    best = { 1.2881396800E+03, 1.4910792535E+03, 5.8323836877E+02, 7.5416644291E+01, 9.6629502864E-01, 3.9797285797E-01,
    4.9727297349E-02 },
    errors = { 4.6647963344E+00, 3.9571156086E+01, 2.8698696102E+01, 5.5675370270E+00, 3.1333340687E-02, 1.4984928198E-02,
    6.5842344623E-03 }, squares = 5.6427082397E+03 },
  Eckerle4 = { x = { 400, 405, 410, 415, 420, 425, 430, 435, 436.5, 438, 439.5, 441, 442.5, 444, 445.5, 447, 448.5, 450, 451.5, 453,
    454.5, 456, 457.5, 459, 460.5, 462, 463.5, 465, 470, 475, 480, 485, 490, 495, 500 },
    y = { 0.0001575, 0.0001699, 0.0002350, 0.0003102, 0.0004917, 0.0008710, 0.0017418, 0.0046400, 0.0065895, 0.0097302, 0.0149002,
    0.0237310, 0.0401683, 0.0712559, 0.1264458, 0.2073413, 0.2902366, 0.3445623, 0.3698049, 0.3668534, 0.3106727, 0.2078154, 0.1164354,
    0.0616764, 0.0337200, 0.0194023, 0.0117831, 0.0074357, 0.0022732, 0.0008800, 0.0004579, 0.0002345, 0.0001586, 0.0001143, 0.0000710 },
    f = function(b, x) return b[1] / b[2] * exp(-0.5 * ((x - b[3]) / b[2]) ^ 2) end, starts = { { 1, 10, 500 }, { 1.5, 5, 450 } },
    best = { 1.5543827178E+00, 4.0888321754E+00, 4.5154121844E+02 },
    errors = { 1.5408051163E-02, 4.6803020753E-02, 4.6800518816E-02 }, squares = 1.4635887487E-03 },
  MGH09 = { x = { 4, 2, 1, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625 },
    y = { 0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246 },
    f = function(b, x) return b[1] * (x * x + x * b[2]) / (x * x + x * b[3] + b[4]) end,
    starts = { { 25, 39, 41.5, 39 }, { 0.25, 0.39, 0.415, 0.39 } },
    best = { 1.9280693458E-01, 1.9128232873E-01, 1.2305650693E-01, 1.3606233068E-01 },
    errors = { 1.1435312227E-02, 1.9633220911E-01, 8.0842031232E-02, 9.0025542308E-02 }, squares = 3.0750560385E-04 },
  MGH10 = { x = counted(50, 125, 5), y = { 34780, 28610, 23650, 19630, 16370, 13720, 11540, 9744, 8261, 7030, 6005, 5147, 4427, 3820,
    3307, 2872 },
    f = function(b, x) return b[1] * exp(b[2] / (x + b[3])) end, starts = { { 2, 400000, 25000 }, { 0.02, 4000, 250 } },
    best = { 5.6096364710E-03, 6.1813463463E+03, 3.4522363462E+02 },
    errors = { 1.5687892471E-04, 2.3309021107E+01, 7.8486103508E-01 }, squares = 8.7945855171E+01,
    bounds = { { 1e-4, 10 }, { 1e3, 1e6 }, { 10, 1e5 } } },
}

--- The parameters without bounds, or logarithmic between these.
local function parameters_of(start, bounds)
  local parameters = {}
  for k, value in ipairs(start) do
    parameters[k] = { name = "b" .. k, size = math.abs(value), start = value }
    if bounds then
      parameters[k].from, parameters[k].to, parameters[k].log = bounds[k][1], bounds[k][2], true
    end
  end
  return parameters
end

local function near(what, got, wanted, tolerance)
  assert(math.abs(got / wanted - 1) <= tolerance, ("%s: %.12g, certified %.12g"):format(what, got, wanted))
end

local function is_certified(own, parameters, count)
  local found, judged = plain.fit({ parameters = parameters, x = own.x, y = own.y, f = own.f, enough = 1e-20, most = 5000, refusals = 40,
    always = true, central = true, share = 1e-5 }, count)
  near("sum of squares", found.at.cost, own.squares, 1e-9)
  for k, value in ipairs(judged.values) do
    near("b" .. k, value, own.best[k], 1e-6)
    near("its standard error", judged.errors[k], own.errors[k], 1e-4)
  end
  equal(found.ended ~= "most", true)
end

for name, own in pairs(problems) do
  for i, start in ipairs(own.starts) do
    local several = own.bounds and i == 1 -- the first start alone leads to another minimum
    test(("%s from start %d%s"):format(name, i, several and " and points between bounds" or ""), function()
      is_certified(own, parameters_of(start, several and own.bounds), several and 16 or 1)
    end)
  end
end
