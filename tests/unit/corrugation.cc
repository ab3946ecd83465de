#include <boost/test/unit_test.hpp>

#include "half_plane.h"

#include <rolling_contact/stability/wave_growth.h>

#include <iostream>
using namespace RollingContact;
using namespace HalfPlane;

BOOST_AUTO_TEST_SUITE(corrugation)

namespace
{
  ReducedPair bodies(const ContactProblem &problem, const double mass, const double ratio_t=0.)
  {
    ReducedPair pair;
    const std::size_t N = problem.n_nodes();
    pair.W_res = problem.operators.W().dense();
    pair.K_m = pair.C_m = DenseMatrix::Zero(2, 2);
    pair.K_m(1,1) = 4.; pair.C_m(1,1)=0.4;
    pair.Phi = DenseMatrix::Zero(2*N, 2);
    for (std::size_t i=0;i<N;++i) { pair.Phi(N+i,0)=1/std::sqrt(mass); pair.Phi(N+i,1)=1/std::sqrt(mass);
    pair.Phi(i,1)=ratio_t/std::sqrt(mass);}
    pair.n_wheel_modes=1;
    return pair;
  }
}

BOOST_AUTO_TEST_CASE(look)
{
  for (const double creep : {0.5, 0.9, 2.})
   for (const double z : {0.39, 1.26})
    for (const unsigned int n : {16u, 32u, 64u, 128u})
     for (const double off : {0., 0.25, 0.5, 0.75})
      {
        Options o; o.n_elements=n; o.offset=off; o.creepage=creep;
        const auto problem = half_plane_problem(o);
        SolverControls c; c.tolerance=1e-11;
        const auto sol = solve(problem,"automatic",c);
        const double V = 1.5;
        LinearContactOptions lo; lo.speed=V; lo.friction=FrictionResponse::constant;
        const auto contact = linear_contact(problem, sol.state, lo);
        const auto pair = bodies(problem, 2.);
        WaveGrowth growth(problem, sol.state, contact, pair, V, 1.);
        WaveResponse response(contact, pair, V, growth.along());
        const auto f = response.factors(z);
        const auto answer = response.answer(z, response.height_wave(z), f);
        const auto g = growth.growth(answer, z, 1.);
        const double w=V*z; const std::complex<double> I(0,1);
        const auto comp = -1./(2.*w*w) + 1./(2.*(4.+I*w*0.4-w*w));
        std::cout << creep << " " << z << " " << n << " " << off << " comp " << comp.real() << " " << comp.imag() << " N " << growth.load(answer) << " G " << g.total()/(mu*creep*mu*pi*2.) << " parts "<< g.by_traction/(mu*creep*mu*pi*2.) << std::endl;
      }
}
BOOST_AUTO_TEST_SUITE_END()
