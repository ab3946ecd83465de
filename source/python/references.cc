#include "bindings.h"
#include <pybind11/numpy.h>

#include <rolling_contact/references/carter.h>
#include <rolling_contact/references/contact_modulus.h>
#include <rolling_contact/references/fastsim.h>
#include <rolling_contact/references/hertz_ellipse.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/references/kalker.h>
#include <rolling_contact/references/polach.h>
#include <rolling_contact/references/shen_hedrick_elkins.h>

namespace RollingContact::Bindings
{
  using namespace References;

  namespace
  {
    /**
     * A theory of creep forces over arrays of creepages, which are broadcast:
     * forces (..., n_components) in the shape of the creepages.
     */
    template <std::size_t n_components, typename Theory>
    py::array_t<double> forces_over(const py::array_t<double> &x,
                                    const py::array_t<double> &y,
                                    const py::array_t<double> &spin,
                                    const Theory              &theory)
    {
      const py::object broadcast =
        py::module_::import("numpy").attr("broadcast_arrays")(x, y, spin);
      std::array<py::array_t<double, py::array::c_style | py::array::forcecast>,
                 3>
        creepages;
      for (std::size_t k = 0; k < 3; ++k)
        creepages[k] = py::object(broadcast[py::int_(k)]);
      std::vector<py::ssize_t> shape(creepages[0].shape(),
                                     creepages[0].shape() +
                                       creepages[0].ndim());
      shape.push_back(n_components);
      py::array_t<double> forces(shape);
      double             *next = forces.mutable_data();
      for (py::ssize_t i = 0; i < creepages[0].size(); ++i)
        for (const double force : theory(Creepages{creepages[0].data()[i],
                                                   creepages[1].data()[i],
                                                   creepages[2].data()[i]}))
          *next++ = force;
      return forces;
    }

    using Plane = std::array<double, 2>;

    Plane plane(const TangentialForce &force)
    {
      return {{force.x, force.y}};
    }

    void define_hertz(py::module_ &module)
    {
      py::class_<HertzLine>(module,
                            "HertzLine",
                            "Hertz's line contact. Units: m, Pa.")
        .def_readonly("half_width", &HertzLine::half_width, "Unit: m.")
        .def_readonly("max_pressure", &HertzLine::max_pressure, "Unit: Pa.")
        .def(
          "load_per_length",
          [](const HertzLine &self) { return self.load_per_length(); },
          "Unit: N/m.")
        .def(
          "pressure",
          [](const HertzLine &self, const py::array_t<double> &x) {
            return py::vectorize(
              [&self](const double at) { return self.pressure(at); })(x);
          },
          py::arg("x"),
          "Pressure at the distance x from the middle (m; a number or an "
          "array). Unit: Pa.");
      py::class_<HertzEllipse>(module,
                               "HertzEllipse",
                               "Hertz's elliptic contact. Units: m, Pa.")
        .def_readonly("half_width_x", &HertzEllipse::half_width_x, "Unit: m.")
        .def_readonly("half_width_y", &HertzEllipse::half_width_y, "Unit: m.")
        .def_readonly("max_pressure", &HertzEllipse::max_pressure, "Unit: Pa.")
        .def_readonly("approach", &HertzEllipse::approach, "Unit: m.")
        .def(
          "load",
          [](const HertzEllipse &self) { return self.load(); },
          "Unit: N.")
        .def(
          "pressure",
          [](const HertzEllipse        &self,
             const py::array_t<double> &x,
             const py::array_t<double> &y) {
            return py::vectorize([&self](const double at_x, const double at_y) {
              return self.pressure(at_x, at_y);
            })(x, y);
          },
          py::arg("x"),
          py::arg("y"),
          "Pressure at the place (x, y) from the middle (m; numbers or "
          "arrays). Unit: Pa.");
      module.def("hertz_line",
                 &hertz_line,
                 py::arg("load_per_length"),
                 py::arg("relative_radius"),
                 py::arg("contact_modulus"),
                 "The contact of parallel cylinders. Units of the arguments: "
                 "N/m, m, Pa.");
      module.def("hertz_ellipse",
                 &hertz_ellipse,
                 py::arg("load"),
                 py::arg("curvature_x"),
                 py::arg("curvature_y"),
                 py::arg("contact_modulus"),
                 "The contact of surfaces whose gap without load is "
                 "curvature_x x^2 + curvature_y y^2. Units of the arguments: "
                 "N, 1/m, 1/m, Pa.");
    }

    void define_elasticity(py::module_ &module)
    {
      module.def("contact_modulus",
                 &contact_modulus,
                 py::arg("young_modulus_1"),
                 py::arg("poisson_ratio_1"),
                 py::arg("young_modulus_2"),
                 py::arg("poisson_ratio_2"),
                 "Contact modulus E* of two bodies; a modulus of inf is a "
                 "rigid body. Unit: Pa.");
      module.def("relative_radius",
                 &relative_radius,
                 py::arg("radius_1"),
                 py::arg("radius_2"),
                 "Relative radius R of two profiles; a radius of inf is flat. "
                 "Unit: m.");
      module.def(
        "kalker_coefficients",
        [](const double axis_ratio, const double poisson_ratio) {
          const auto found =
            References::kalker_coefficients(axis_ratio, poisson_ratio);
          return py::make_tuple(found.C11, found.C22, found.C23, found.C33);
        },
        py::arg("axis_ratio"),
        py::arg("poisson_ratio"),
        "Kalker's coefficients (C11, C22, C23, C33) for an ellipse with the "
        "axis ratio a/b, a along x. Unit: 1.");
    }

    void define_carter(py::module_ &module)
    {
      py::class_<Carter>(module,
                         "Carter",
                         "Carter's line contact of alike half-planes in steady "
                         "rolling.")
        .def(py::init<HertzLine, double, double, double, int>(),
             py::arg("contact"),
             py::arg("relative_radius"),
             py::arg("friction_coefficient"),
             py::arg("creepage"),
             py::arg("flow_direction") = 1,
             "contact is a HertzLine; units of the others: m, 1, 1. Material "
             "flows in +x (1) or -x (-1).")
        .def_property_readonly("saturation_creepage",
                               [](const Carter &self) {
                                 return self.saturation_creepage();
                               })
        .def_property_readonly("stick_interval",
                               [](const Carter &self) {
                                 return self.stick_interval();
                               })
        .def_property_readonly("force_ratio",
                               [](const Carter &self) {
                                 return self.force_ratio();
                               })
        .def(
          "traction",
          [](const Carter &self, const py::array_t<double> &x) {
            return py::vectorize(
              [&self](const double at) { return self.traction(at); })(x);
          },
          py::arg("x"),
          "Traction on the wheel at the distance x from the middle (m; a "
          "number or an array). Unit: Pa.");
    }

    /** A theory of forces that friction bounds, with its name and help. */
    template <typename Theory>
    void define_theory(py::module_  &module,
                       const char   *name,
                       const Theory &theory,
                       const char   *help)
    {
      module.def(
        name,
        [theory](const py::array_t<double> &creepage_x,
                 const py::array_t<double> &creepage_y,
                 const py::array_t<double> &spin,
                 const HertzEllipse        &contact,
                 const double               shear_modulus,
                 const double               poisson_ratio,
                 const double               friction_coefficient,
                 const int                  flow_direction) {
          return forces_over<2>(
            creepage_x, creepage_y, spin, [&](const Creepages &creepages) {
              return theory(creepages,
                            contact,
                            CombinedElasticity{shear_modulus, poisson_ratio},
                            friction_coefficient,
                            flow_direction);
            });
        },
        py::arg("creepage_x"),
        py::arg("creepage_y"),
        py::arg("spin"),
        py::arg("contact"),
        py::arg("shear_modulus"),
        py::arg("poisson_ratio"),
        py::arg("friction_coefficient"),
        py::arg("flow_direction") = 1,
        help);
    }

    void define_kalker(py::module_ &module)
    {
      module.def(
        "kalker",
        [](const py::array_t<double> &creepage_x,
           const py::array_t<double> &creepage_y,
           const py::array_t<double> &spin,
           const HertzEllipse        &contact,
           const double               shear_modulus,
           const double               poisson_ratio,
           const int                  flow_direction) {
          return forces_over<
            3>(creepage_x, creepage_y, spin, [&](const Creepages &creepages) {
            const auto found = kalker_forces(creepages,
                                             contact,
                                             {shear_modulus, poisson_ratio},
                                             flow_direction);
            return std::array<double, 3>{{found.x, found.y, found.spin_moment}};
          });
        },
        py::arg("creepage_x"),
        py::arg("creepage_y"),
        py::arg("spin"),
        py::arg("contact"),
        py::arg("shear_modulus"),
        py::arg("poisson_ratio"),
        py::arg("flow_direction") = 1,
        "Kalker's linear theory of an ellipse in m, G in Pa, spin in 1/m: (..., "
        "3) of force x, y and spin moment on the wheel. Units: N, N, N m.");
    }

    void define_theories(py::module_ &module)
    {
      using C = const Creepages &;
      using H = const HertzEllipse &;
      using E = const CombinedElasticity &;
      define_theory(
        module,
        "shen_hedrick_elkins",
        [](
          C c, H contact, E elasticity, const double friction, const int flow) {
          return plane(References::shen_hedrick_elkins(
            c, contact, elasticity, friction, flow));
        },
        "Kalker's linear force, saturated: (..., 2) of force x and y on the "
        "wheel. Unit: N.");
      define_theory(
        module,
        "fastsim",
        [](
          C c, H contact, E elasticity, const double friction, const int flow) {
          return plane(
            References::fastsim(c, contact, elasticity, friction, flow));
        },
        "Kalker's simplified theory: (..., 2) of force x and y on the wheel. "
        "Unit: N.");
      define_theory(
        module,
        "polach",
        [](C c, H contact, E elasticity, const double friction, const int) {
          return plane(References::polach(c, contact, elasticity, friction));
        },
        "Polach's formula, without spin: (..., 2) of force x and y on the "
        "wheel. Unit: N.");
    }
  } // namespace

  void define_references(py::module_ &module)
  {
    py::module_ references =
      module.def_submodule("references",
                           "Closed forms and theories of half-spaces, over "
                           "numpy arrays.");
    define_hertz(references);
    define_elasticity(references);
    define_carter(references);
    define_kalker(references);
    define_theories(references);
  }
} // namespace RollingContact::Bindings
