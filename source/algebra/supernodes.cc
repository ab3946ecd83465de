#include <cholmod.h>

#include <rolling_contact/algebra/supernodes.h>

#include <algorithm>

namespace RollingContact
{
  Supernodes::Supernodes(const cholmod_factor &L)
    : super(static_cast<const Index *>(L.super))
    , pi(static_cast<const Index *>(L.pi))
    , px(static_cast<const Index *>(L.px))
    , s(static_cast<const Index *>(L.s))
    , x(static_cast<const double *>(L.x))
    , n_supernodes(L.nsuper)
  {}

  int Supernodes::max_n_rows() const
  {
    int result = 0;
    for (Index k = 0; k < size(); ++k)
      result = std::max(result, n_rows(k));
    return result;
  }
} // namespace RollingContact
