// Two surfaces of different meshes joined: how the nodes of one follow those of the other, by integrals over
// the reference with dual functions.
#pragma once
#include "contact/surface/cell_surface.hpp"

namespace stiction::contact {

/// How far apart tied surfaces may lie, in parts of the larger facet; and how much of a facet may lie bare,
/// or beneath two: what chords of different lengths leave along an arc.
inline constexpr double tied_gap = 0.1, tied_bare = 0.05;

/// What one facet of the surface that follows asks for, a row for each of its nodes j:
///   sum_k D_jk u_k = sum_l M_jl u_l,   D_jk = int psi_j N_k,   M_jl = int psi_j N_l
/// with functions psi_j that sum to 1 and are orthogonal to all N_k but N_j (Wohlmuth 2000; Popp, Gitterle,
/// Gee and Wall 2010). Where some N_j has no area of its own (tri6, quad8, edges of three nodes about an
/// axis) they are so to functions of which corners have borrowed a fifth of the middles beside them (Popp,
/// Wohlmuth, Gee and Wall 2012): rows of middles then have D at the corners beside them too.
struct TiedFacet {
  Indices own, other; ///< nodes of both surfaces, corners of `own` first
  Dense D, M; ///< [own, own], [own, other], m^2 (m in plane strain); empty where too little is covered
  double covered = 0; ///< part of its area that faces the other surface
  double gap = 0;     ///< smallest to what would face it but lies too far away, m; 0: there is none
  double reach = 0;   ///< how far away its counterpart may lie, m
};

/// Facet by facet of `own`; around: areas of full turns about x = 0. Throws InputError where a facet is too
/// distorted.
[[nodiscard]] std::vector<TiedFacet> tie(CellSurface const& own, CellSurface const& other, bool around);

} // namespace stiction::contact
