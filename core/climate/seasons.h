// A place's year: its temperature swings as T + S cos(2 pi t) about the mean T (°C) by S (K).
//
//   mean_above       mean over the year of max(T + S cos - threshold, 0)
//   biotemperature   mean over the year of temperatures held within 0 to 30 °C (Holdridge 1967)
//   evapotranspiration   what plants and ground could give off, 0.05893 m/yr a degree of
//                    biotemperature (Holdridge 1967)
//   snow_cover       share of the year in which snow lies. Rain that falls below 0 °C is snow; it
//                    melts by `melt` metres of water a kelvin and year above 0 °C (the degree-day
//                    law, Hock 2003, doi:10.1016/S0022-1694(03)00257-9). From where more falls than
//                    can melt, 1: the snow line.
//
// Paper B's scales, 0 to 1, from these:
//
//   warmth   = (T + 15) / 50: its limits 0.2, 0.4, 0.7 are -5, 5, 20 °C, Whittaker's limits of
//              tundra, boreal forest and the tropics
//   wetness  = P / (P + E), E the evapotranspiration, at least 0.2 m/yr: 0.5 where as much falls
//              as could be given off
#pragma once

namespace orogen {

double mean_above(double threshold, double mean, double swing);
double biotemperature(double mean, double swing);
double evapotranspiration(double biotemperature);  // m/yr
/// `rain` in m/yr, `melt` in m/(K yr).
double snow_cover(double mean, double swing, double rain, double melt);

double warmth(double mean);
double wetness(double rain, double evapotranspiration);
/// The rain (m/yr) of a wetness; infinite at 1.
double rain_of_wetness(double wetness, double evapotranspiration);

inline constexpr double kWarmthDegrees = 50.0;  // °C from warmth 0 to 1

}  // namespace orogen
