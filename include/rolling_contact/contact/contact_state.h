#ifndef rolling_contact_contact_contact_state_h
#define rolling_contact_contact_contact_state_h

#include <rolling_contact/contact/edge_extrapolation.h>

namespace RollingContact
{
  /**
   * The unknowns of a contact problem: pressure and traction at the nodes, and
   * the approach when the load is given. Units: Pa, m.
   */
  struct ContactState
  {
    std::vector<double> pressure;
    NodalField          traction;
    double              approach = 0.;
    SlipScheme          scheme;                 ///< of the slip rows
    bool                edge_law = true;        ///< if B1 has one
    std::vector<double> friction;               ///< mu it was solved with
    bool                holds_friction = false; ///< mu stays, whatever the slip
    bool                holds_scheme   = false; ///< the scheme stays as it is

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[pressure,
             traction,
             approach,
             scheme,
             edge_law,
             friction,
             holds_friction,
             holds_scheme] = *this;
      archive &pressure &traction &approach &scheme &edge_law &friction
        &holds_friction &holds_scheme;
    }
  };
} // namespace RollingContact

#endif
