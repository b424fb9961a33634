// Recordings as lines of numbers: CSV with a header (or x, y, time, pressure without one) and MyPaint's events.
#include "model/formats/ink/recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace suffuse {

namespace {

enum InkColumn { X, Y, Time, Pressure, Width, Altitude, StrokeName, columnCount };
using Columns = std::array<int, columnCount>;
constexpr std::array<InkColumn, 6> numberColumns{X, Y, Time, Pressure, Width, Altitude};

struct Row {
    std::array<double, numberColumns.size()> values{0, 0, 0, 1, 0, 0}; ///< in the order of InkColumn
    std::string stroke;
};

/// Larger coordinates of the pen, and larger times (in the recording's unit), are not believed.
constexpr double largestValue = 1e15;

class Lines {
public:
    explicit Lines(const QByteArray &bytes) : m_rest(bytes.constData(), std::size_t(bytes.size()))
    {
        if (m_rest.starts_with("\xef\xbb\xbf"))
            m_rest.remove_prefix(3);
    }
    /// Reads the next line that is neither empty nor a comment (#).
    bool next(std::string_view &line)
    {
        while (!m_rest.empty()) {
            const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
            line = trimmed(m_rest.substr(0, end));
            m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
            ++m_number;
            if (!line.empty() && line.front() != '#')
                return true;
        }
        return false;
    }
    qint64 number() const { return m_number; }

private:
    std::string_view m_rest;
    qint64 m_number = 0;
};

std::vector<std::string_view> cellsOf(std::string_view line, char separator)
{
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t end = std::min(line.find(separator), line.size());
        std::string_view cell = trimmed(line.substr(0, end));
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
            cell = cell.substr(1, cell.size() - 2);
        cells.push_back(cell);
        if (end == line.size())
            return cells;
        line.remove_prefix(end + 1);
    }
}

char separatorOf(std::string_view line)
{
    for (const char c : {'\t', ';', ','}) {
        if (line.find(c) != line.npos)
            return c;
    }
    return ',';
}

/// Finds a column by its possible names, the best first. A name also matches the end of a longer one ("SPLINE_X").
int findColumn(const std::vector<std::string> &header, std::initializer_list<std::string_view> names)
{
    for (const bool whole : {true, false}) {
        for (const std::string_view name : names) {
            for (std::size_t k = 0; k < header.size(); ++k) {
                const std::string_view title = header[k];
                const bool ending = !whole && title.ends_with(name) && title.size() > name.size() &&
                                    title[title.size() - name.size() - 1] == '_';
                if (title == name || ending)
                    return int(k);
            }
        }
    }
    return -1;
}

struct Header {
    Columns columns = [] {
        Columns none{};
        none.fill(-1);
        return none;
    }();
    double secondsPerUnit = 0; ///< the unit of the time in seconds; 0: it must be found from the steps
    QString leftOut;           ///< the columns that are not used, as a sentence
};

Header headerOf(const std::vector<std::string_view> &cells)
{
    std::vector<std::string> names;
    for (const std::string_view cell : cells) {
        std::string &name = names.emplace_back(cell);
        std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    }
    Header h;
    h.columns[X] = findColumn(names, {"x"});
    h.columns[Y] = findColumn(names, {"y"});
    h.columns[Time] =
        findColumn(names, {"time", "t", "timestamp", "time_ms", "t_ms", "ms", "time_s", "t_s", "seconds"});
    h.columns[Pressure] = findColumn(names, {"pressure", "p", "force"});
    h.columns[StrokeName] = findColumn(names, {"stroke", "idx", "stroke_id", "strokeid", "stroke_index"});
    h.columns[Width] = findColumn(names, {"width", "size", "thickness"});
    h.columns[Altitude] = findColumn(names, {"altitude"});
    std::vector<LeftOut> others;
    for (std::size_t k = 0; k < names.size() && others.size() < 8; ++k)
        if (!names[k].empty() && std::ranges::find(h.columns, int(k)) == h.columns.end())
            others.push_back({1, FileMessages::tr("column “%1”").arg(excerpt(cells[k]))});
    h.leftOut = leftOutSentence(others);
    if (h.columns[Time] >= 0) {
        const std::string &name = names[std::size_t(h.columns[Time])];
        if (name.ends_with("ms"))
            h.secondsPerUnit = 1e-3;
        else if (name.ends_with("_s") || name == "seconds")
            h.secondsPerUnit = 1;
    }
    return h;
}

/// The median of the steps between neighbours of a path, without steps of 0; 0 if there are none.
double medianStep(const std::vector<std::vector<Row>> &paths)
{
    std::vector<double> steps;
    for (const auto &rows : paths) {
        for (std::size_t k = 1; k < rows.size(); ++k) {
            const double step = rows[k].values[Time] - rows[k - 1].values[Time];
            if (step > 0)
                steps.push_back(step);
        }
    }
    if (steps.empty())
        return 0;
    const auto middle = steps.begin() + std::ptrdiff_t(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// The unit of time, from the usual step: pens report every 1 to 50 ms.
double secondsPerStep(double step)
{
    return step < 0.5 ? 1 : step < 500 ? 1e-3 : 1e-6;
}

/// Sets the times where there are some. Some recorders write for the start of a stroke the milliseconds since 1970, and
/// add the seconds since then. Such a stroke keeps its start in milliseconds and its steps in seconds.
void setTimes(Recording &recording, const std::vector<std::vector<Row>> &paths, const Header &header)
{
    if (header.columns[Time] < 0) {
        AssumedTimes times;
        for (Recording::Path &path : recording.paths)
            times.give(path);
        return;
    }
    const double unit = header.secondsPerUnit > 0 ? header.secondsPerUnit : secondsPerStep(medianStep(paths));
    constexpr double millisecondsIn1973 = 1e11;
    double first = std::numeric_limits<double>::infinity();
    for (const auto &rows : paths) {
        for (const Row &row : rows)
            first = std::min(first, row.values[Time]);
    }
    for (std::size_t j = 0; j < paths.size(); ++j) {
        const double start = paths[j].front().values[Time];
        const double startUnit = unit == 1 && start > millisecondsIn1973 ? 1e-3 : unit;
        for (std::size_t k = 0; k < paths[j].size(); ++k) {
            const double t = (start - first) * startUnit + (paths[j][k].values[Time] - start) * unit;
            recording.paths[j].samples[k].time = toMicroseconds(std::clamp(t, -1e9, 1e9));
        }
    }
}

/// The factor for pressures. Pressures above 1 are steps of the device, of which the greatest becomes 1. If all
/// pressures of a recording are 0, it has none.
double pressureScale(const std::vector<std::vector<Row>> &paths)
{
    double most = 0;
    for (const auto &rows : paths) {
        for (const Row &row : rows)
            most = std::max(most, row.values[Pressure]);
    }
    return most > 1 ? 1 / most : most > 0 ? 1 : 0;
}

/// Radians for each unit of the altitude's column. It is 0 where pens wrote 0 throughout, since they do not measure it.
double altitudeScale(const std::vector<std::vector<Row>> &paths)
{
    double most = 0;
    for (const auto &rows : paths)
        for (const Row &row : rows)
            most = std::max(most, row.values[Altitude]);
    constexpr double degree = std::numbers::pi / 180;
    return most > 3.2 ? degree : most > 0 ? 1 : 0;
}

Recording toRecording(const std::vector<std::vector<Row>> &paths, const Header &header)
{
    Recording recording;
    recording.leftOut = header.leftOut;
    const double scale = pressureScale(paths), radians = altitudeScale(paths);
    for (const auto &rows : paths) {
        auto &path = recording.paths.emplace_back();
        for (const Row &row : rows) {
            const double p = scale > 0 ? std::clamp(row.values[Pressure] * scale, 0.0, 1.0) : 1;
            const float tilt = radians > 0 ? tiltOf(row.values[Altitude] * radians) : 0;
            path.samples.push_back({{row.values[X], row.values[Y]}, 0, float(p), tilt});
            if (header.columns[Width] >= 0)
                path.widths.push_back(std::clamp(row.values[Width], 0.0, 1e6));
        }
    }
    setTimes(recording, paths, header);
    return recording;
}

QString columnName(int column)
{
    static constexpr const char *names[] = {"x", "y", "time", "pressure", "width", "altitude", "stroke"};
    return QLatin1String(names[column]);
}

class RowReader {
public:
    RowReader(const Header &header, const QString &fileName) : m_header(header), m_fileName(fileName) {}

    /// Reads a row. If it returns false, error() says why.
    bool read(const std::vector<std::string_view> &cells, qint64 line, Row &row)
    {
        for (const InkColumn column : numberColumns) {
            const int k = m_header.columns[std::size_t(column)];
            if (k < 0 || (column >= Pressure && std::size_t(k) < cells.size() && cells[std::size_t(k)].empty()))
                continue;
            const std::string_view cell = std::size_t(k) < cells.size() ? cells[std::size_t(k)] : std::string_view();
            const auto value = numberIn(cell);
            if (!value || std::abs(*value) > largestValue) {
                m_error =
                    fileError(m_fileName, FileMessages::tr("line %1, column %2: “%3” is not a number within ±1e15")
                                              .arg(line)
                                              .arg(columnName(column), excerpt(cell)));
                return false;
            }
            row.values[std::size_t(column)] = *value;
        }
        const int k = m_header.columns[StrokeName];
        if (k >= 0 && std::size_t(k) < cells.size())
            row.stroke = cells[std::size_t(k)];
        return true;
    }
    const Error &error() const { return m_error; }

private:
    const Header &m_header;
    QString m_fileName;
    Error m_error{};
};

/// Splits rows into paths by the stroke column, or where the pen is up (pressure 0).
std::vector<std::vector<Row>> splitPaths(std::vector<Row> rows, bool named, bool pressed)
{
    std::vector<std::vector<Row>> paths;
    if (named) {
        std::map<std::string, std::size_t> places;
        for (Row &row : rows) {
            const auto [at, isNew] = places.try_emplace(row.stroke, paths.size());
            if (isNew)
                paths.emplace_back();
            paths[at->second].push_back(std::move(row));
        }
        return paths;
    }
    const bool lifts =
        pressed && std::any_of(rows.begin(), rows.end(), [](const Row &r) { return r.values[Pressure] > 0; });
    bool down = false;
    for (Row &row : rows) {
        if (lifts && !(row.values[Pressure] > 0)) {
            down = false;
            continue;
        }
        if (!down)
            paths.emplace_back();
        down = true;
        paths.back().push_back(std::move(row));
    }
    return paths;
}

Result<std::vector<Row>> readRows(Lines &lines, const Header &header, char separator, const QString &fileName,
                                  std::string_view firstLine)
{
    std::vector<Row> rows;
    RowReader reader(header, fileName);
    std::string_view line = firstLine;
    while (!line.empty() || lines.next(line)) {
        if (!reader.read(cellsOf(line, separator), lines.number(), rows.emplace_back()))
            return reader.error();
        line = {};
    }
    return rows;
}

} // namespace

Result<Recording> readInkCsv(const QByteArray &bytes, const QString &fileName)
{
    Lines lines(bytes);
    std::string_view line;
    if (!lines.next(line))
        return fileError(fileName, FileMessages::tr("is empty; there is nothing to paint"));
    const char separator = separatorOf(line);
    const auto cells = cellsOf(line, separator);
    Header header = headerOf(cells);
    const bool headless = numberIn(cells.front()).has_value();
    if (headless) {
        for (std::size_t k = 0; k < std::min<std::size_t>(cells.size(), 4); ++k)
            header.columns[k] = int(k);
    }
    if (header.columns[X] < 0 || header.columns[Y] < 0)
        return fileError(fileName,
                         FileMessages::tr("line %1: no columns x and y; name the columns x, y, time and pressure")
                             .arg(lines.number()));
    auto rows = readRows(lines, header, separator, fileName, headless ? line : std::string_view());
    if (!rows)
        return Error{rows.error()};
    return toRecording(splitPaths(std::move(*rows), header.columns[StrokeName] >= 0, header.columns[Pressure] >= 0),
                       header);
}

Result<Recording> readMyPaintEvents(const QByteArray &bytes, const QString &fileName)
{
    Lines lines(bytes);
    std::string_view line;
    Header header;
    header.secondsPerUnit = 1;
    header.columns = {1, 2, 0, 3, -1, -1, -1};
    std::vector<Row> rows;
    RowReader reader(header, fileName);
    while (lines.next(line)) {
        std::string spaced(line);
        std::replace(spaced.begin(), spaced.end(), '\t', ' ');
        const auto last =
            std::unique(spaced.begin(), spaced.end(), [](char a, char b) { return a == ' ' && b == ' '; });
        spaced.erase(last, spaced.end());
        if (!reader.read(cellsOf(spaced, ' '), lines.number(), rows.emplace_back()))
            return reader.error();
    }
    return toRecording(splitPaths(std::move(rows), false, true), header);
}

} // namespace suffuse
