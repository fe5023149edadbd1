#include "vegetation/plant_rates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr double kSquareMetres = 1e4;  // a hectare
constexpr double kMostCrowding = 5.0;  // a: above it fewer than one try in five stays
constexpr int kMostRounds = 1000;
constexpr double kAccuracy = 1e-9;

/// a of each kind: how many tries are expected nearer than spacings allow.
std::vector<double> crowding(const PlantTable& table, const std::vector<double>& tries) {
  std::vector<double> result(tries.size());
  for (std::size_t i = 0; i < tries.size(); ++i)
    for (std::size_t j = 0; j < tries.size(); ++j) {
      const double d = 0.5 * (table.kinds[i].spacing + table.kinds[j].spacing);
      if (tries[i] > 0.0) result[i] += tries[j] * std::numbers::pi * d * d;
    }
  return result;
}

/// Tries of each kind of which so many stay; empty if there is no such number. Rises from `wanted`
/// to the smallest solution.
std::vector<double> tries_for(const PlantTable& table, const std::vector<double>& wanted) {
  std::vector<double> tries = wanted;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<double> a = crowding(table, tries);
    double change = 0.0;
    for (std::size_t k = 0; k < tries.size(); ++k) {
      if (a[k] > kMostCrowding) return {};
      const double next = a[k] > 0.0 ? wanted[k] * a[k] / -std::expm1(-a[k]) : wanted[k];
      change = std::max(change, (next - tries[k]) / std::max(next, 1e-300));
      tries[k] = next;
    }
    if (change < kAccuracy) return tries;
  }
  return {};
}

[[noreturn]] void refuse(const PlantTable& table, std::size_t biome, double factor) {
  double low = 0.0, high = factor;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (tries_for(table, wanted_plants(table, biome, middle)).empty() ? high : low) = middle;
  }
  const auto plants = [&](double share) {
    return std::to_string(std::lround(share * table.density[biome]));
  };
  throw InputError("density: " + plants(factor) + " plants a hectare of " +
                   std::string(info(Biome(biome)).name) +
                   " cannot stand at their spacings; at most " + plants(low) + " can");
}

}  // namespace

std::vector<double> wanted_plants(const PlantTable& table, std::size_t biome, double factor) {
  double all = 0.0;
  for (const PlantKind& kind : table.kinds) all += kind.weight[biome];
  std::vector<double> wanted;
  for (const PlantKind& kind : table.kinds)
    wanted.push_back(
        all > 0.0 ? factor * table.density[biome] / kSquareMetres * kind.weight[biome] / all : 0.0);
  return wanted;
}

PlantRates plant_rates(const PlantTable& table, double factor,
                       const std::array<bool, kBiomes>& there) {
  PlantRates rates;
  for (std::size_t biome = 0; biome < std::size_t(kBiomes); ++biome) {
    if (!there[biome]) continue;
    const std::vector<double> wanted = wanted_plants(table, biome, factor);
    std::vector<double> tries = tries_for(table, wanted);
    if (tries.size() != wanted.size()) refuse(table, biome, factor);
    for (std::size_t k = 1; k < tries.size(); ++k) tries[k] += tries[k - 1];
    rates.up_to_kind[biome] = std::move(tries);
    rates.most = std::max(rates.most, rates.of_biome(biome));
  }
  return rates;
}

}  // namespace orogen
