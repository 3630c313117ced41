#include "petsc/distributed_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bondstatic/error.hpp"
#include "petsc/mpi_lifetime.hpp"
#include "petsc/session.hpp"
#include "system/block_row.hpp"
#include "system/body_positions.hpp"
#include "system/refresh.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

constexpr PetscInt block = 6;

Index reduced(Index mine, MPI_Op operation) {
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_INT64_T, operation, PETSC_COMM_WORLD));
  return mine;
}

Index sum_of_lower_ranks(Index mine) {
  Index up_to_here = 0;
  check_mpi(MPI_Scan(&mine, &up_to_here, 1, MPI_INT64_T, MPI_SUM, PETSC_COMM_WORLD));
  return up_to_here - mine;
}

}  // namespace

DistributedSystem::DistributedSystem(const BondNetwork& network, const FreeDofs& dofs)
    : incidence_(link_incidence(network)) {
  check_mpi(MPI_Comm_rank(PETSC_COMM_WORLD, &rank_));
  check_mpi(MPI_Comm_size(PETSC_COMM_WORLD, &ranks_));
  if (ranks_ > 1 && !ranks_of(network))
    throw Error(
        ExitCode::invalid_input,
        fmt::format("one of {} ranks was given a whole network to solve\n    cure: give each rank its "
                    "share of the network, or start one process",
                    ranks_));
  const Index own_rows = count_rows(network, dofs);
  rows_ = reduced(own_rows, MPI_SUM);
  layout_ = lay_out(network, dofs, sum_of_lower_ranks(own_rows));
  for (const Index body : layout_.body) {
    const BlockCount count = count_blocks(network, incidence_, dofs, body);
    counts_.push_back(count);
    blocks_ += count.all;
  }
  check_index_range(rows_, reduced(blocks_, MPI_MAX), PETSC_MAX_INT);
  if (Ranks* const ranks = ranks_of(network)) take_rows_of_copies(*ranks, network, dofs);
}

void DistributedSystem::take_rows_of_copies(Ranks& ranks, const BondNetwork& network, const FreeDofs& dofs) {
  refresh(ranks, network.share->neighbours, layout_.row);
  for (auto p = std::size_t(network.own()); p < layout_.row.size(); ++p)
    if ((layout_.row[p] >= 0) != (dofs.first[p + 1] > dofs.first[p]))
      throw Error(ExitCode::internal,
                  fmt::format("rank {} and the rank that its body {} is a copy from do not agree on whether "
                              "it may move",
                              rank_, p));
}

void DistributedSystem::allocate() {
  std::vector<PetscInt> own, other;
  for (const BlockCount& count : counts_) {
    own.push_back(PetscInt(count.own));
    other.push_back(PetscInt(count.all - count.own));
  }
  const auto rows = block * PetscInt(layout_.body.size());
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
  for (const Index body : layout_.body) {
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
  if (rows_ == 0) return;
  std::vector<Vector3> along_branches;
  if (!network.share) along_branches = body_positions(network, incidence_);
  const std::vector<Vector3>& positions = network.share ? network.share->position : along_branches;
  std::array<PetscVector, 6> modes;
  std::array<Vec, 6> raw{};
  for (int i = 0; i < 6; ++i) {
    modes[std::size_t(i)] = make_vector();
    raw[std::size_t(i)] = modes[std::size_t(i)];
    PetscScalar* values = nullptr;
    check_petsc(VecGetArray(raw[std::size_t(i)], &values));
    PetscScalar* next = values;
    const Vector3 unit = Vector3::Unit(i % 3);
    for (const Index body : layout_.body) {
      Vector6 motion = Vector6::Zero();
      if (i < 3)
        motion.head<3>() = unit;
      else
        motion << unit.cross(positions[std::size_t(body)]), network.rotation_length * unit;
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
  for (const Index body : layout_.body)
    for (int i = 0; i < block; ++i, ++next)
      if (!dofs.is_free(body, i)) *next = 0;
  check_petsc(VecRestoreArray(vector, &values));
}

void DistributedSystem::scatter(const FreeDofs& dofs, Eigen::Ref<const Eigen::VectorXd> unknowns,
                                Vec vector) const {
  PetscScalar* values = nullptr;
  check_petsc(VecGetArray(vector, &values));
  PetscScalar* next = values;
  for (const Index body : layout_.body) {
    Index unknown = dofs.first[std::size_t(body)];
    for (int i = 0; i < block; ++i) *next++ = dofs.is_free(body, i) ? unknowns[unknown++] : 0.0;
  }
  check_petsc(VecRestoreArray(vector, &values));
}

void DistributedSystem::gather(const BondNetwork& network, const FreeDofs& dofs, Vec vector,
                               Eigen::Ref<Eigen::VectorXd> unknowns) const {
  const PetscScalar* values = nullptr;
  check_petsc(VecGetArrayRead(vector, &values));
  std::vector<std::array<double, block>> motion(std::size_t(network.bodies));
  const PetscScalar* next = values;
  for (const Index body : layout_.body)
    for (double& value : motion[std::size_t(body)]) value = *next++;
  check_petsc(VecRestoreArrayRead(vector, &values));
  if (Ranks* const ranks = ranks_of(network)) refresh(*ranks, network.share->neighbours, motion);
  for_each_unknown(
      dofs, [&](std::size_t p, int i, Index unknown) { unknowns[unknown] = motion[p][std::size_t(i)]; });
}

AnalysisReport DistributedSystem::report(const BondNetwork& network, const FreeDofs& dofs) const {
  Index entries = 0;
  for (const Index body : layout_.body) entries += twice_the_entries(network, incidence_, dofs, body);
  AnalysisReport report;
  report.unknowns = reduced(dofs.first[std::size_t(network.own())], MPI_SUM);
  report.matrix_entries = reduced(entries, MPI_SUM) / 2;
  report.ordering = ranks_ == 1 ? "1 rank" : fmt::format("{} ranks", ranks_);
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
