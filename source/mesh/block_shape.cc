#include <rolling_contact/mesh/block_shape.h>

namespace RollingContact
{
  namespace
  {
    /**
     * Chart of a block: x and y are Cartesian, w is stretched between the
     * surface and the flat bottom.
     */
    class BlockChart : public SurfaceChart
    {
    public:
      BlockChart(const BlockShape &block, const CoarseCells &cells)
        : block(block)
        , cells(cells)
      {}

      Point to_body(const Point &chart_point) const override
      {
        const auto [x, y, w]       = chart_point;
        const double below_surface = w / block.thickness_below();
        return {{x, y, block.surface_height(x, y) * (1 + below_surface) + w}};
      }

      Point to_chart(const Point &body_point) const override
      {
        const auto [x, y, z] = body_point;
        const double height  = block.surface_height(x, y);
        return {{x, y, (z - height) / (1 + height / block.thickness_below())}};
      }

      std::vector<double> edges_x() const override
      {
        return break_points(-block.reach_x(), block.reach_x(), cells);
      }

    private:
      const BlockShape &block;
      const CoarseCells cells;
    };
  } // namespace

  void BlockShape::check(const unsigned int dimension, const bool rigid) const
  {
    if (rigid)
      return;
    const auto above_0 = [&](const std::string &entry, const double value) {
      parameters.require(value > 0., entry, value, "it must be above 0 m.");
    };
    above_0("Block length", parameters.block_length);
    above_0("Block depth", parameters.block_depth);
    check_extent(dimension, reach_x());
  }

  double BlockShape::thickness_below() const
  {
    return parameters.block_depth;
  }

  double BlockShape::reach_x() const
  {
    return parameters.block_length / 2;
  }

  std::unique_ptr<SurfaceChart>
  BlockShape::chart(const CoarseCells &cells) const
  {
    return std::make_unique<BlockChart>(*this, cells);
  }

  std::vector<double> BlockShape::dimensions() const
  {
    return {parameters.radius,
            parameters.lateral_radius,
            parameters.block_length,
            parameters.block_depth,
            parameters.width};
  }
} // namespace RollingContact
