#ifndef rolling_contact_scene_study_parameters_h
#define rolling_contact_scene_study_parameters_h

#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Accuracy study`.
   */
  struct StudyParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError.
     */
    void check(const unsigned int dimension) const;

    /**
     * Meshes that the levels of `adaptive` start from.
     */
    const std::vector<unsigned int> &starts_of_levels() const
    {
      return adaptive_starts.empty() ? elements : adaptive_starts;
    }

    bool                      varies_time_step = false; ///< instead of the mesh
    std::vector<unsigned int> elements{12, 24, 48, 96};
    unsigned int              n_offsets             = 8;
    unsigned int              reference_elements    = 192;
    bool                      extrapolate_reference = true;
    std::vector<double>       creepages{0.1, 0.3, 0.5, 0.7, 0.9};
    std::vector<std::string>  directions{"longitudinal"};
    std::vector<std::string>  meshes{"uniform"};
    unsigned int              rim_levels      = 2;
    unsigned int              adaptive_levels = 2;
    std::vector<unsigned int> adaptive_starts;
    std::vector<std::string>  slip_operators{"calibrated", "upwind 2"};
    std::vector<std::string>  solvers{"automatic"};
    bool                      combines_all    = false; ///< else one at a time
    double                    paper_tolerance = 1e-3;
    std::vector<double>       time_steps{4e-6, 8e-6, 16e-6};
    std::vector<double>       thetas{0.5, 1.};
    double                    reference_time_step = 1e-6;

  private:
    void declare_meshes(Entries &entries);
    void declare_methods(Entries &entries);
    void check_meshes() const;
    void check_time_steps() const;
  };
} // namespace RollingContact

#endif
