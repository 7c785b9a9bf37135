// Settings of every time scheme, read as a script's tables, with what is known of each.
#pragma once
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "dynamics/marching.hpp"

namespace stiction::test {

struct SchemeSample {
  std::string name;  ///< of the scheme
  std::string label; ///< of these settings
  Input table;
  int order = 0;             ///< on a smooth problem; 0: the scheme has no dynamics
  bool massless = false;     ///< contact nodes
  bool cells = false;        ///< stress of their cells at the step's end
  bool closed_rates = false; ///< linear recursion without cures: `amplification` below holds
  double beta = 0, gamma = 0, alpha_m = 0, alpha_f = 0; ///< of Newmark's family, by the papers' formulas
  double theta = 0, xi = 0;                             ///< of Jean's
};

inline SchemeSample theta_sample(std::string name, double theta, double xi, core::Table more, int order) {
  more["theta"] = value(theta);
  if (name == "theta_xi")
    more["xi"] = value(xi);
  SchemeSample sample{name, name + " theta " + std::to_string(theta) + " xi " + std::to_string(xi),
                      make("scheme." + name, std::move(more)), order};
  sample.theta = theta;
  sample.xi = xi;
  return sample;
}

inline SchemeSample newmark_sample(std::string name, core::Table settings, int order) {
  std::string label = name;
  for (auto const& [key, setting] : settings)
    label += " " + key;
  return {name, label, make("scheme." + name, std::move(settings)), order};
}

/// Names of the choices of contact_inertia and contact_level.
inline core::Table cure(char const* inertia, char const* level = "position") {
  return {{"contact_inertia", text(inertia)}, {"contact_level", text(level)}};
}

inline core::Table with(core::Table table, std::string key, double number) {
  table[std::move(key)] = value(number);
  return table;
}

inline void add_newmark_family(std::vector<SchemeSample>& all) {
  auto add = [&](SchemeSample sample, std::array<double, 4> const& known) {
    sample.closed_rates = true;
    sample.beta = known[0], sample.gamma = known[1], sample.alpha_m = known[2], sample.alpha_f = known[3];
    for (double const c : known)
      sample.label += " " + std::to_string(c);
    all.push_back(std::move(sample));
  };
  for (char const* level : {"position", "velocity"})
    add(newmark_sample("newmark", cure("full", level), 2), {0.25, 0.5, 0, 0});
  add(newmark_sample("newmark", with(with(cure("full"), "beta", 0.5), "gamma", 0.9), 1), {0.5, 0.9, 0, 0});
  for (double const rho : {0.0, 0.3, 1.0}) {
    double const m = (2 * rho - 1) / (rho + 1), f = rho / (rho + 1);
    add(newmark_sample("generalised_alpha", with(cure("full"), "rho_inf", rho), 2),
        {std::pow(1 - m + f, 2) / 4, 0.5 - m + f, m, f});
  }
  add(newmark_sample("hht", with(cure("full"), "alpha", -0.2), 2), {0.36, 0.7, 0, 0.2});
}

/// Some settings of every scheme.
inline std::vector<SchemeSample> scheme_samples() {
  std::vector<SchemeSample> all;
  for (auto const& [theta, xi] : {std::pair{0.5, 0.5}, {0.7, 0.7}, {0.5, 0.8}, {0.8, 0.5}}) {
    all.push_back(theta_sample("theta_xi", theta, xi, cure("full"), theta == 0.5 && xi == 0.5 ? 2 : 1));
    all.back().closed_rates = true;
  }
  for (double const theta : {0.5, 0.7}) {
    all.push_back(theta_sample("moreau_jean", theta, theta, {}, theta == 0.5 ? 2 : 1));
    all.back().closed_rates = true;
  }
  add_newmark_family(all);
  all.push_back(theta_sample("theta_xi", 0.5, 0.5, cure("implicit"), 1));
  all.push_back(theta_sample("theta_xi", 0.6, 0.7, cure("cells"), 1));
  all.back().cells = true;
  all.push_back(theta_sample("theta_xi", 0.5, 0.5, cure("none", "velocity"), 2));
  all.back().massless = true;
  for (char const* name : {"newmark", "generalised_alpha", "hht"}) {
    all.push_back(newmark_sample(name, cure("implicit", "velocity"), 1));
    all.push_back(newmark_sample(name, cure("none"), 2));
    all.back().massless = true;
  }
  all.push_back(newmark_sample("central_difference", {}, 2));
  all.push_back(newmark_sample("quasi_static", {}, 0));
  return all;
}

} // namespace stiction::test
