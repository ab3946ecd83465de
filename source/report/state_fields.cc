#include <rolling_contact/report/body_fields.h>
#include <rolling_contact/report/interface_fields.h>
#include <rolling_contact/report/state_fields.h>

namespace RollingContact
{
  template <int dim>
  void
  write_interface(const SceneParameters  &scene,
                  const SteadyState<dim> &steady,
                  RunFolder              &folder,
                  const std::string      &file)
  {
    const auto rail = scene.rail.body_shape();
    write_interface_fields<dim>(
      steady.pair->trace(),
      steady.problem,
      steady.state,
      !steady.restored,
      [&](const double x, const double y) {
        return rail->surface_height(x, y);
      },
      folder,
      file);
  }



  template <int dim>
  std::vector<PvdBlock>
  write_bodies(const SteadyState<dim>               &steady,
               const std::function<BodyField(Side)> &displacement,
               const std::function<std::string(const std::string &)> &file_name,
               const double                                           time,
               RunFolder                                             &folder)
  {
    std::vector<PvdBlock> blocks;
    unsigned int          part = 0;
    for (const Side side : {Side::wheel, Side::rail})
      if (steady.pair->is_elastic(side))
        {
          const bool        is_wheel = side == Side::wheel;
          const std::string file =
            write_body_fields<dim>(steady.pair->body(side),
                                   steady.pair->rank_of(side),
                                   displacement(side),
                                   {is_wheel,
                                    is_wheel ? -steady.state.approach : 0.},
                                   folder,
                                   file_name(name_of(side)));
          blocks.push_back({time, part++, name_of(side), file});
        }
    return blocks;
  }



  template void
  write_interface(const SceneParameters &,
                  const SteadyState<2> &,
                  RunFolder &,
                  const std::string &);
  template void
  write_interface(const SceneParameters &,
                  const SteadyState<3> &,
                  RunFolder &,
                  const std::string &);
  template std::vector<PvdBlock>
  write_bodies(const SteadyState<2> &,
               const std::function<BodyField(Side)> &,
               const std::function<std::string(const std::string &)> &,
               const double,
               RunFolder &);
  template std::vector<PvdBlock>
  write_bodies(const SteadyState<3> &,
               const std::function<BodyField(Side)> &,
               const std::function<std::string(const std::string &)> &,
               const double,
               RunFolder &);
} // namespace RollingContact
