#ifndef rolling_contact_pair_mesh_limits_h
#define rolling_contact_pair_mesh_limits_h

#include <rolling_contact/mesh/grading.h>
#include <rolling_contact/scene/pair_spec.h>

#include <array>
#include <string>

namespace RollingContact
{
  /**
   * Smallest element in x that bodies of the program's own meshes may have, as
   * a part of the largest of their sizes: below some 1e-8 rounding of the
   * vertices decides whether the surface nodes of wheel and rail match.
   */
  inline constexpr double smallest_element = 3e-8;

  /**
   * Half the width of the narrower of the bodies that the program meshes as
   * discs and blocks; infinite if there is none. Units: m.
   */
  double narrower_reach(const PairSpec &scene);

  /**
   * Length along x and, in 3D, width of a body about the origin that ends an
   * element beyond the zone: where it does, all bodies have the zone's elements
   * in common. Units: m.
   */
  template <int dim>
  std::array<double, 2> room_for_zone(const Grading<dim> &grading);

  /**
   * A length to ask for, rounded up: "at least 0.0123 m". Units: m.
   */
  std::string at_least(const double length);

  /**
   * Coordinates across between which true sections face each other, infinite
   * without such. Units: m.
   */
  std::array<double, 2> room_of_sections(const PairSpec &scene);

  /**
   * End a zone with boxes where true sections no longer face each other; and
   * end a zone without boxes at the side of the narrower body, unless a patch
   * of this half-width goes beyond that, and let a whole number of elements
   * reach to there where it is near, as the last element of a body makes up for
   * the rest, which bodies of unlike width do not have in common; a multiple of
   * four, as else there are no coarse cells which they are parts of. Units: m.
   */
  template <int dim>
  void end_at_side(const PairSpec &scene,
                   const double    half_width_y,
                   Grading<dim>   &grading);

  /**
   * Cells of the bodies that the program meshes, counted without making them,
   * and a text with those of each; the meshes have somewhat more.
   */
  struct CellCount
  {
    double      total = 0.;
    std::string text;
  };

  template <int dim>
  CellCount cells_to_mesh(const PairSpec &scene, const Grading<dim> &grading);

  /**
   * Throws InputError, naming the load or approach and the least that will do,
   * if the elements of @p grading are too small for the bodies: a patch grows
   * with the square root of the approach and of a load in 2D, with the cube
   * root of a load in 3D.
   */
  template <int dim>
  void check_element_size(const PairSpec &scene, const Grading<dim> &grading);

  /**
   * How many nodes of the contact a mesh will have, by the zone and the size of
   * its elements alone; there will be somewhat more.
   */
  template <int dim>
  double contact_nodes(const Grading<dim> &grading);

  /**
   * Throws MemoryError if the dense matrices of contact space with so many
   * unknowns, W of each body and of the pair and products of it, do not fit
   * into 70 % of the free memory; @p on_grid: the answers of every second node,
   * of a compliance that is no matrix.
   */
  void check_contact_memory(const double n_unknowns, const bool on_grid);

  /**
   * Check the memory of the contact problem before a mesh is made, by its
   * contact_nodes(). Throws MemoryError.
   */
  template <int dim>
  void check_contact_memory(const PairSpec     &scene,
                            const Grading<dim> &grading,
                            const bool          on_grid);
} // namespace RollingContact

#endif
