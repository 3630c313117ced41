#include "petsc/distributed_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "petsc/mpi_lifetime.hpp"
#include "petsc/session.hpp"
#include "system/block_row.hpp"
#include "system/body_positions.hpp"

namespace bondstatic {

namespace {

constexpr PetscInt block = 6;

}  // namespace

DistributedSystem::DistributedSystem(const BondNetwork& network, const FreeDofs& dofs)
    : incidence_(link_incidence(network)), positions_(body_positions(network, incidence_)) {
  check_mpi(MPI_Comm_rank(PETSC_COMM_WORLD, &rank_));
  check_mpi(MPI_Comm_size(PETSC_COMM_WORLD, &ranks_));
  layout_ = lay_out(positions_, dofs, ranks_);
  for (const Index body : own_bodies()) {
    const BlockCount count = count_blocks(network, incidence_, layout_, rank_, body);
    counts_.push_back(count);
    blocks_ += count.all;
  }
  Index most = blocks_;
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, PETSC_COMM_WORLD));
  check_index_range(layout_.rows(), most, PETSC_MAX_INT);
}

void DistributedSystem::allocate() {
  std::vector<PetscInt> own, other;
  for (const BlockCount& count : counts_) {
    own.push_back(PetscInt(count.own));
    other.push_back(PetscInt(count.all - count.own));
  }
  const auto rows = block * PetscInt(own_bodies().size());
  check_petsc(MatCreate(PETSC_COMM_WORLD, matrix_.fresh()));
  check_petsc(MatSetSizes(matrix_, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE));
  check_petsc(MatSetBlockSize(matrix_, block));
  check_petsc(MatSetType(matrix_, MATAIJ));  // GAMG does not take blocked storage
  check_petsc(MatXAIJSetPreallocation(matrix_, block, own.data(), other.data(), nullptr, nullptr));
  check_petsc(MatSetOption(matrix_, MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
  check_petsc(MatSetOption(matrix_, MAT_SYMMETRIC, PETSC_TRUE));
  check_petsc(MatSetOption(matrix_, MAT_SYMMETRY_ETERNAL, PETSC_TRUE));
}

void DistributedSystem::assemble(const BondNetwork& network, const FreeDofs& dofs) {
  if (matrix_)
    check_petsc(MatZeroEntries(matrix_));
  else
    allocate();
  BlockRow row;
  std::vector<PetscInt> columns;
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor> values;
  for (const Index body : own_bodies()) {
    block_row(network, incidence_, dofs, body, row);
    columns.clear();
    values.resize(6, 6 * Index(row.size()));
    for (const auto& [neighbour, entries] : row) {
      const Index column = layout_.row[std::size_t(neighbour)];
      if (column < 0) continue;
      values.middleCols(6 * Index(columns.size()), 6) = entries;
      columns.push_back(PetscInt(column));
    }
    values.conservativeResize(6, 6 * Index(columns.size()));
    const auto here = PetscInt(layout_.row[std::size_t(body)]);
    check_petsc(MatSetValuesBlocked(matrix_, 1, &here, PetscInt(columns.size()), columns.data(),
                                    values.data(), INSERT_VALUES));
  }
  check_petsc(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  check_petsc(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
}

PetscVector DistributedSystem::make_vector() const {
  PetscVector vector;
  check_petsc(MatCreateVecs(matrix_, vector.fresh(), nullptr));
  return vector;
}

void DistributedSystem::attach_rigid_modes(const BondNetwork& network) {
  if (layout_.rows() == 0) return;
  std::array<PetscVector, 6> modes;
  std::array<Vec, 6> raw{};
  for (int i = 0; i < 6; ++i) {
    modes[std::size_t(i)] = make_vector();
    raw[std::size_t(i)] = modes[std::size_t(i)];
    PetscScalar* values = nullptr;
    check_petsc(VecGetArray(raw[std::size_t(i)], &values));
    PetscScalar* next = values;
    const Vector3 unit = Vector3::Unit(i % 3);
    for (const Index body : own_bodies()) {
      Vector6 motion = Vector6::Zero();
      if (i < 3)
        motion.head<3>() = unit;
      else
        motion << unit.cross(positions_[std::size_t(body)]), network.rotation_length * unit;
      next = std::copy(motion.begin(), motion.end(), next);
    }
    check_petsc(VecRestoreArray(raw[std::size_t(i)], &values));
    std::array<PetscScalar, 6> shares{};
    check_petsc(VecMDot(raw[std::size_t(i)], i, raw.data(), shares.data()));
    for (PetscScalar& share : shares) share = -share;
    check_petsc(VecMAXPY(raw[std::size_t(i)], i, shares.data(), raw.data()));
    check_petsc(VecNormalize(raw[std::size_t(i)], nullptr));
  }
  PetscNullSpace space;
  check_petsc(MatNullSpaceCreate(PETSC_COMM_WORLD, PETSC_FALSE, 6, raw.data(), space.fresh()));
  check_petsc(MatSetNearNullSpace(matrix_, space));
}

void DistributedSystem::clear_held(const FreeDofs& dofs, Vec vector) const {
  PetscScalar* values = nullptr;
  check_petsc(VecGetArray(vector, &values));
  PetscScalar* next = values;
  for (const Index body : own_bodies())
    for (int i = 0; i < block; ++i, ++next)
      if (!dofs.is_free(body, i)) *next = 0;
  check_petsc(VecRestoreArray(vector, &values));
}

void DistributedSystem::scatter(const FreeDofs& dofs, Eigen::Ref<const Eigen::VectorXd> unknowns,
                                Vec vector) const {
  PetscScalar* values = nullptr;
  check_petsc(VecGetArray(vector, &values));
  PetscScalar* next = values;
  for (const Index body : own_bodies()) {
    Index unknown = dofs.first[std::size_t(body)];
    for (int i = 0; i < block; ++i) *next++ = dofs.is_free(body, i) ? unknowns[unknown++] : 0.0;
  }
  check_petsc(VecRestoreArray(vector, &values));
}

void DistributedSystem::gather(const FreeDofs& dofs, Vec vector, Eigen::Ref<Eigen::VectorXd> unknowns) const {
  std::vector<int> counts, starts;
  for (int rank = 0; rank < ranks_; ++rank) {
    counts.push_back(block * int(layout_.bodies_of(rank).size()));
    starts.push_back(block * int(layout_.first[std::size_t(rank)]));
  }
  std::vector<double> all(std::size_t(block * layout_.rows()));
  const PetscScalar* values = nullptr;
  check_petsc(VecGetArrayRead(vector, &values));
  check_mpi(MPI_Allgatherv(values, counts[std::size_t(rank_)], MPI_DOUBLE, all.data(), counts.data(),
                           starts.data(), MPI_DOUBLE, PETSC_COMM_WORLD));
  check_petsc(VecRestoreArrayRead(vector, &values));
  const double* next = all.data();
  for (const Index body : layout_.body) {
    Index unknown = dofs.first[std::size_t(body)];
    for (int i = 0; i < block; ++i, ++next)
      if (dofs.is_free(body, i)) unknowns[unknown++] = *next;
  }
}

AnalysisReport DistributedSystem::report(const BondNetwork& network, const FreeDofs& dofs) const {
  AnalysisReport report;
  report.unknowns = dofs.unknowns();
  report.ordering = ranks_ == 1 ? "1 rank" : fmt::format("{} ranks by coordinate bisection", ranks_);
  // Blocks of the lower triangle between unknowns, as the direct solvers count them.
  const auto width = [&](Index p) { return dofs.first[std::size_t(p) + 1] - dofs.first[std::size_t(p)]; };
  Index entries = 0;
  std::vector<Index> neighbours;
  for (const Index body : layout_.body) {
    entries += width(body) * (width(body) + 1) / 2;
    neighbours.clear();
    for (const Index k : incidence_.of(body)) {
      const Link& link = network.links[std::size_t(k)];
      const Index other = link.a == body ? link.b : link.a;
      if (other < body) neighbours.push_back(other);
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (const Index other : neighbours) entries += width(body) * width(other);
  }
  report.matrix_entries = entries;
  return report;
}

double DistributedSystem::matrix_bytes() const {
  return 36.0 * double(blocks_) * (sizeof(PetscScalar) + sizeof(PetscInt));
}

double DistributedSystem::on_this_machine(double bytes) const {
  MPI_Comm machine = MPI_COMM_NULL;
  check_mpi(MPI_Comm_split_type(PETSC_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine));
  const int code = MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_SUM, machine);
  MPI_Comm_free(&machine);
  check_mpi(code);
  return bytes;
}

}  // namespace bondstatic
