#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/hdf5_file.h>
#include <rolling_contact/base/hdf5_reader.h>
#include <rolling_contact/contact/contact_problem_file.h>
#include <rolling_contact/contact/tangential_problem.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    using Numbers = std::vector<double>;

    /**
     * An HDF5 file whose arrays have units.
     */
    class ProblemFile
    {
    public:
      explicit ProblemFile(const std::filesystem::path &name)
        : file(name)
      {
        for (const char *group :
             {"/operators", "/trace", "/loads", "/solution"})
          file.make_group(group);
      }

      void add(const std::string     &path,
               const Hdf5File::Shape &shape,
               const Numbers         &values,
               const std::string     &unit)
      {
        file.write(path, shape, values);
        file.set_attribute(path, "unit", unit);
      }

      void add(const std::string &path,
               const SparseRows  &rows,
               const std::string &unit)
      {
        Numbers triplets;
        for (unsigned int i = 0; i < rows.size(); ++i)
          for (const auto &[column, value] : rows[i])
            triplets.insert(triplets.end(), {double(i), double(column), value});
        add(path, {triplets.size() / 3, 3}, triplets, unit);
      }

      void add(const std::string &path,
               const NodalField  &field,
               const std::string &unit)
      {
        add(path,
            {field.n_components(), field.n_nodes()},
            Numbers(field.begin(), field.end()),
            unit);
      }

      Hdf5File file;
    };

    void add_operators(const ContactOperators &operators,
                       const ContactMatrices   matrices,
                       ProblemFile            &file)
    {
      const DenseMatrix matrix = operators.W().dense();
      const std::size_t n = operators.n_nodes(), size = matrix.rows();
      Numbers           W, positions, frames;
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
          W.push_back(matrix(i, j));
      for (const auto &[x, y] : operators.positions())
        positions.insert(positions.end(), {x, y});
      for (const SurfaceFrames::Node &node : operators.frames().nodes)
        frames.insert(frames.end(), {node.y, node.z, node.angle});
      file.add("/operators/positions", {n, 2}, positions, "m");
      file.add("/operators/W", {size, size}, W, "m/N");
      file.add("/operators/H", operators.H(), "m2");
      file.add("/operators/frames",
               {frames.size() / 3, 3},
               frames,
               "m, m, rad");
      file.add("/operators/load_angle",
               {1},
               {operators.frames().load_angle},
               "rad");
      const NormalTangentialCoupling &coupling = operators.coupling();
      file.add("/operators/coupling",
               {3},
               {double(coupling.exists),
                coupling.dundurs_beta,
                coupling.antiplane_share},
               "1");
      file.add("/operators/nodal_forces",
               {1},
               {double(operators.nodal_forces())},
               "0 of elements, 1 hats");
      const SlipOperator &B1 = operators.slip_operator();
      file.file.write("/operators/slip_operator", name_of(B1.kind()));
      file.add("/operators/flow", {1}, {double(B1.flow_direction())}, "1");
      file.add("/operators/contact_matrices",
               {1},
               {double(matrices)},
               "0 lumped, 1 consistent, 2 balanced");
      file.add("/operators/B1", B1.rows(), "1/m");
    }

    void add_trace(const Trace &trace, ProblemFile &file)
    {
      Numbers      boxes;
      SparseRows   corners(trace.cells.empty()
                           ? 0
                           : trace.cells.size() *
                               trace.cells.front().corners.size());
      unsigned int k = 0;
      for (const Trace::Cell &cell : trace.cells)
        {
          boxes.insert(
            boxes.end(),
            {cell.lower[0], cell.lower[1], cell.upper[0], cell.upper[1]});
          for (const SparseRows::Row &corner : cell.corners)
            corners[k++] = corner;
        }
      file.add("/trace/boxes", {trace.cells.size(), 4}, boxes, "m");
      file.add("/trace/corners", corners, "1");
      file.add("/trace/dimensions", {1}, {double(trace.n_dimensions)}, "1");
    }

    void add_loads(const ContactLoads &loads, ProblemFile &file)
    {
      const std::size_t n = loads.gap.size();
      file.add("/loads/gap", {n}, loads.gap, "m");
      file.add("/loads/friction", {n}, loads.friction, "1");
      file.add("/loads/creepages",
               {3},
               {loads.creepages.x, loads.creepages.y, loads.creepages.spin},
               "1, 1, 1/m");
      if (loads.slip_of_profile.n_components() > 0)
        file.add("/loads/slip_of_profile", loads.slip_of_profile, "1");
      if (loads.normal_load)
        file.add("/loads/normal_load", {1}, {*loads.normal_load}, "N");
      else
        file.add("/loads/approach", {1}, {loads.approach}, "m");
    }

    void add_solution(const ContactProblem &problem,
                      const ContactState   &state,
                      ProblemFile          &file)
    {
      const std::size_t n = problem.n_nodes();
      file.add("/solution/pressure", {n}, state.pressure, "Pa");
      file.add("/solution/approach", {1}, {state.approach}, "m");
      Numbers gap = problem.operators.normal_displacement(state.pressure);
      if (problem.n_tangential() > 0)
        {
          const TangentialProblem tangential =
            tangential_problem(problem, state);
          file.add("/solution/traction", state.traction, "Pa");
          file.add("/solution/slip", tangential.slip(state.traction), "1");
          file.add("/solution/B1", tangential.rows.B1, "1/m");
          Numbers edges;
          for (const ContactEdge &edge : tangential.rows.edges)
            edges.push_back(edge.nodes.front());
          file.add("/solution/leading_edges", {edges.size()}, edges, "node");
          const Numbers more =
            problem.operators.normal_displacement_of_traction(state.traction);
          for (std::size_t i = 0; i < n; ++i)
            gap[i] += more[i];
        }
      for (std::size_t i = 0; i < n; ++i)
        gap[i] += problem.loads.gap[i] -
                  problem.operators.approach_share(i) * state.approach;
      file.add("/solution/gap", {n}, gap, "m");
    }

    SparseRows rows_of(const Hdf5Reader  &file,
                       const std::string &path,
                       const std::size_t  n)
    {
      const Numbers triplets = file.numbers(path);
      SparseRows    rows(n);
      for (std::size_t k = 0; k + 2 < triplets.size(); k += 3)
        {
          if (!(triplets[k] >= 0. && triplets[k] < n))
            throw InputError(path + ": there is no row " +
                             std::to_string(triplets[k]) + ".");
          rows[static_cast<unsigned int>(triplets[k])].emplace_back(
            static_cast<unsigned int>(triplets[k + 1]), triplets[k + 2]);
        }
      return rows;
    }

    Trace trace_of(const Hdf5Reader                  &file,
                   const ContactOperators::Positions &nodes)
    {
      Trace trace;
      trace.n_dimensions          = file.numbers("/trace/dimensions", 1)[0];
      trace.nodes                 = nodes;
      const Numbers     boxes     = file.numbers("/trace/boxes");
      const std::size_t n_cells   = boxes.size() / 4,
                        n_corners = std::size_t(1) << trace.n_dimensions;
      const SparseRows corners =
        rows_of(file, "/trace/corners", n_cells * n_corners);
      for (std::size_t k = 0; k < n_cells; ++k)
        {
          Trace::Cell cell;
          cell.lower = {{boxes[4 * k], boxes[4 * k + 1]}};
          cell.upper = {{boxes[4 * k + 2], boxes[4 * k + 3]}};
          for (std::size_t c = 0; c < n_corners; ++c)
            cell.corners.push_back(corners[k * n_corners + c]);
          trace.cells.push_back(cell);
        }
      return trace;
    }

    SlipOperator slip_operator_of(const Hdf5Reader     &file,
                                  const Trace          &trace,
                                  const ContactMatrices matrices,
                                  const bool            friction)
    {
      const std::string name = file.text("/operators/slip_operator");
      for (const auto &choice : slip_operator_choices())
        if (choice.name == name)
          return friction ? SlipOperator(trace,
                                         choice.kind,
                                         matrices,
                                         file.numbers("/operators/flow", 1)[0])
                          : SlipOperator(choice.kind);
      throw InputError("/operators/slip_operator: no operator has the name \"" +
                       name + "\".");
    }

    /**
     * Files of earlier versions are of finite elements.
     */
    NodalForces nodal_forces_of(const Hdf5Reader &file)
    {
      const std::string path = "/operators/nodal_forces";
      return file.has(path) && file.numbers(path, 1)[0] != 0.
               ? NodalForces::hats
               : NodalForces::of_elements;
    }

    ContactOperators operators_of(const Hdf5Reader &file, StoredProblem &stored)
    {
      const Numbers at              = file.numbers("/operators/positions"),
                    W_values        = file.numbers("/operators/W"),
                    frames          = file.numbers("/operators/frames"),
                    coupling        = file.numbers("/operators/coupling", 3);
      const std::size_t           n = at.size() / 2;
      ContactOperators::Positions positions(n);
      for (std::size_t i = 0; i < n; ++i)
        positions[i] = {{at[2 * i], at[2 * i + 1]}};
      std::size_t size = n;
      while (size * size < W_values.size())
        size += n;
      if (n == 0 || size * size != W_values.size())
        throw InputError("/operators/W: it is not square, or of other nodes.");
      DenseMatrix W(size, size);
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
          W(i, j) = W_values[i * size + j];
      SurfaceFrames surface;
      surface.load_angle = file.numbers("/operators/load_angle", 1)[0];
      for (std::size_t k = 0; k + 2 < frames.size(); k += 3)
        surface.nodes.push_back({frames[k], frames[k + 1], frames[k + 2]});
      stored.trace    = trace_of(file, positions);
      stored.matrices = static_cast<ContactMatrices>(
        static_cast<int>(file.numbers("/operators/contact_matrices", 1)[0]));
      SlipOperator B1 =
        slip_operator_of(file, stored.trace, stored.matrices, size > n);
      ContactOperators operators(positions,
                                 rows_of(file, "/operators/H", n),
                                 std::move(W),
                                 std::move(B1),
                                 {coupling[0] != 0., coupling[1], coupling[2]},
                                 nodal_forces_of(file));
      operators.set_frames(std::move(surface));
      return operators;
    }
  } // namespace

  std::string contact_problem_bytes(const Trace                 &trace,
                                    const ContactMatrices        matrices,
                                    const ContactProblem        &problem,
                                    const ContactState          &state,
                                    const std::filesystem::path &name)
  {
    if (problem.loads.friction_law)
      throw InputError("\"" + name.string() +
                       "\": there is no place in it for friction that depends "
                       "on the sliding speed; take a constant one.");
    ProblemFile file(name);
    add_operators(problem.operators, matrices, file);
    add_trace(trace, file);
    add_loads(problem.loads, file);
    add_solution(problem, state, file);
    return file.file.bytes();
  }

  StoredProblem read_contact_problem(const std::filesystem::path &name)
  {
    const Hdf5Reader file(name);
    StoredProblem    stored;
    stored.problem.operators = operators_of(file, stored);
    const std::size_t n      = stored.problem.n_nodes();
    ContactLoads     &loads  = stored.problem.loads;
    loads.gap                = file.numbers("/loads/gap", n);
    loads.friction           = file.numbers("/loads/friction", n);
    const Numbers creepages  = file.numbers("/loads/creepages", 3);
    loads.creepages          = {creepages[0], creepages[1], creepages[2]};
    if (file.has("/loads/slip_of_profile"))
      loads.slip_of_profile =
        NodalField(n, file.numbers("/loads/slip_of_profile"));
    if (file.has("/loads/normal_load"))
      loads.normal_load = file.numbers("/loads/normal_load", 1)[0];
    else
      loads.approach = file.numbers("/loads/approach", 1)[0];
    stored.state.pressure = file.numbers("/solution/pressure", n);
    stored.state.approach = file.numbers("/solution/approach", 1)[0];
    if (stored.problem.n_tangential() > 0)
      stored.state.traction = NodalField(n, file.numbers("/solution/traction"));
    return stored;
  }
} // namespace RollingContact
