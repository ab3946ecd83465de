#ifndef rolling_contact_contact_friction_memory_h
#define rolling_contact_contact_friction_memory_h

#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  /**
   * Friction that comes to the value of its law over a sliding distance d, for
   * each point of the material: dmu/ds = -(mu - mu_law)/d along its path, s the
   * distance it has slid. In steady rolling a point comes with the static mu
   * and slides |s| h from node to node along a line of flow,
   *   mu_i = mu_law,i + (mu_(i-1) - mu_law,i) E_i,   E_i = exp(-|s_i| h/d);
   * in a time step it slides |s| V dt, and mu_(i-1) is what the point has that
   * arrives at the node, ContactLoads::friction_arriving. After the regularised
   * friction of Ruina and of CONTACT's force law with memory.
   */
  class FrictionMemory
  {
  public:
    /**
     * @p speeds: |s| V of the nodes, m/s. The loads have a friction law and a
     * memory length.
     */
    FrictionMemory(const ContactProblem      &contact,
                   const std::vector<double> &speeds);

    /**
     * mu of the nodes.
     */
    const std::vector<double> &friction() const
    {
      return mu;
    }

    /**
     * What part of a change of the law's mu at a node is one of its mu, 1 - E.
     */
    double immediate_part(const unsigned int i) const
    {
      return 1 - left[i];
    }

    /**
     * dmu/d|s| of some nodes by the sliding speeds of the same nodes, divided
     * by the speed V. Units: s/m.
     */
    DenseMatrix derivative(const std::vector<unsigned int> &nodes) const;

  private:
    /**
     * Node before a node on its line of flow, or itself.
     */
    void find_lines();

    const ContactProblem     &contact;
    const std::vector<double> speeds;
    std::vector<unsigned int> order, before; ///< along the flow
    std::vector<double>       path;          ///< m, per slip
    std::vector<double>       mu, law, left; ///< left: E
  };

  /**
   * A nodal quantity of the material after it moved by a distance with the
   * flow, interpolated along the lines of flow; @p entering where it was not on
   * a line. Units: m.
   */
  std::vector<double> moved_with_flow(const ContactOperators    &operators,
                                      const std::vector<double> &values,
                                      const std::vector<double> &entering,
                                      const double               distance);
} // namespace RollingContact

#endif
