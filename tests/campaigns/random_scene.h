#ifndef rolling_contact_tests_campaigns_random_scene_h
#define rolling_contact_tests_campaigns_random_scene_h

#include "random_source.h"

#include <map>
#include <string>

/**
 * A scene as it is drawn; sections keep their entries.
 */
class RandomScene
{
public:
  RandomScene(const std::uint64_t seed, const unsigned int dimension);

  std::string prm() const;

  /**
   * True for the operators of the paper, which are singular on some patches
   * and need not converge.
   */
  bool may_not_converge() const;

private:
  void
  set(const std::string &section, const std::string &entry, const double value);

  void choose_analysis();

  void choose_shapes();

  double choose_block();

  void choose_lateral_shapes();

  void choose_materials();

  void choose_contact();

  void choose_mesh();

  void choose_time();

  RandomSource       random;
  const unsigned int dimension;
  std::string        analysis, rigid;
  bool               are_twins = false, papers_operators = false;
  double wheel_radius = 0., relative_radius = 0., relative_lateral = 1.,
         smallest = 0., thickness = 1., width = 0., modulus = 0.,
         half_width = 0., largest_creepage = 0.;
  std::map<std::string, std::map<std::string, std::string>> sections;
};

#endif
