#include "render/cuda/cuda_gradient.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

using namespace cuda;
using namespace gradient;

namespace {

constexpr std::size_t mostKeptBytes = std::size_t(1) << 30; // of warps that draw; where they need more, fewer draw
constexpr double mostEntries = double(1u << 31);
constexpr double widestReach = 1e7; // pixels

GradientView gradientView(const View &view)
{
    const double c = view.scale * std::cos(view.rotation), s = view.scale * std::sin(view.rotation);
    const double side = view.mirrored ? -1 : 1;
    const Point at = view.toPixels({0, 0});
    return {side * c, -s, side * s, c, at.x, at.y, view.scale};
}

/// How many tiles of a row or column, of which there are `all`, a node can meet that reaches so far.
std::uint16_t mostTiles(double reach, int all)
{
    const double by = (std::isfinite(reach) ? std::min(reach, widestReach) : widestReach) + 0.1;
    return std::uint16_t(std::min(int((2 * by + gradientSide - 1) / gradientSide) + 1, all));
}

void takeValues(const SegmentNumbers &s, float (&out)[gradientValues])
{
    for (int c = 0; c < 3; ++c)
        out[c] = float(s.colour[c]);
    out[3] = float(s.opacity), out[4] = float(s.granulation);
}

GradientStroke strokeRecord(const FlatScene &scene, const NodeRules &rules, const FlatStroke &stroke)
{
    GradientStroke out{};
    out.first = stroke.first, out.end = stroke.first + stroke.count;
    out.kind = stroke.kind, out.keep = float(stroke.keep), out.varies = !stroke.oneColour;
    for (int i = 0; i < 3; ++i)
        out.xi[i] = float(stroke.xi[i]);
    if (stroke.count == 0)
        return out;
    out.firstNode = rules.segments[out.first].first, out.endNode = rules.segments[out.end - 1].end;
    takeValues(scene.segments[stroke.first], out.constant);
    for (std::uint32_t k = out.first; k < out.end && !scene.marks.empty(); ++k)
        out.fades |= scene.marks[k].fade;
    return out;
}

/// Makes room for one at least, so that there is an address.
template <class T, Where where>
Fault reserveAll(std::size_t count, Buffer<T, where> &buffer)
{
    return buffer.reserve(std::max<std::size_t>(count, 1));
}

/// Returns the first fault of calls, of which those after it are not made.
template <class... Calls>
Fault inTurn(Calls... calls)
{
    Fault fault;
    (void)(... && !(fault = calls()));
    return fault;
}

} // namespace

CudaGradient::CudaGradient(std::shared_ptr<Device> device, Threads threads)
    : m_device(std::move(device)), m_threads(threads), m_segments(*m_device), m_strokes(*m_device), m_sums(*m_device),
      m_losses(*m_device), m_status(*m_device), m_deviceSegments(*m_device), m_deviceStrokes(*m_device),
      m_deviceRules(*m_device), m_nodes(*m_device), m_boxes(*m_device), m_entries(*m_device), m_deviceSums(*m_device),
      m_levels(*m_device), m_devicePaper(*m_device), m_target(*m_device), m_byRgb(*m_device), m_picture(*m_device),
      m_deviceLosses(*m_device), m_kept(*m_device), m_shown(*m_device), m_deviceStatus(*m_device)
{}

void CudaGradient::choose(const FlatScene &scene, const Precision &precision)
{
    m_rules = chooseNodes(scene, precision, m_threads);
    m_rulesThere = false;
}

Fault CudaGradient::setTarget(std::span<const float> rgb)
{
    m_targetSize = 0;
    const Fault fault = inTurn([&] { return m_target.reserve(rgb.size()); },
                               [&] { return m_device->upload(m_target.data(), rgb.data(), rgb.size_bytes()); },
                               [&] { return m_device->finish(nullptr); });
    if (!fault)
        m_targetSize = rgb.size();
    return fault;
}

Fault CudaGradient::uploadRules()
{
    if (m_rulesThere)
        return {};
    std::vector<GradientRule> records(std::max<std::size_t>(m_rules.nodes.size(), 1));
    for (std::size_t i = 0; i < m_rules.nodes.size(); ++i) {
        std::copy_n(m_rules.nodes[i].point, 4, records[i].point);
        std::copy_n(m_rules.nodes[i].slope, 4, records[i].slope);
        records[i].weight = m_rules.nodes[i].weight;
    }
    const Fault fault = inTurn(
        [&] { return m_deviceRules.reserve(records.size()); },
        [&] { return m_device->upload(m_deviceRules.data(), records.data(), records.size() * sizeof(GradientRule)); });
    m_rulesThere = !fault;
    return fault;
}

Fault CudaGradient::uploadPaper(const FlatScene &scene)
{
    if (scene.paper == m_paper)
        return {};
    m_paper.reset();
    const std::vector<float> &eta = *scene.paper;
    const Fault fault =
        inTurn([&] { return m_devicePaper.reserve(eta.size()); },
               [&] { return m_device->upload(m_devicePaper.data(), eta.data(), eta.size() * sizeof(float)); });
    if (!fault)
        m_paper = scene.paper;
    return fault;
}

void CudaGradient::describe(const FlatScene &scene)
{
    double entries = 0;
    for (std::size_t k = 0; k < scene.segments.size(); ++k) {
        const SegmentNumbers &s = scene.segments[k];
        const SegmentRule &rule = m_rules.segments[k];
        GradientSegment &out = m_segments.data()[k];
        std::copy_n(s.x, 4, out.x), std::copy_n(s.y, 4, out.y);
        out.density = s.density, out.spread = s.spread;
        out.radius = rule.radius, out.cut = rule.cut, out.gain = rule.gain;
        takeValues(s, out.value);
        out.firstNode = rule.first, out.endNode = rule.end;
        out.firstEntry = std::uint32_t(std::min(entries, mostEntries));
        const double reach = rule.radius * s.spread * scene.view.scale;
        out.mostX = mostTiles(reach, m_work.columns), out.mostY = mostTiles(reach, m_work.rows);
        out.lift = !scene.marks.empty() && scene.marks[k].lift;
        out.fade = !scene.marks.empty() && scene.marks[k].fade;
        entries += double(rule.end - rule.first) * out.mostX * out.mostY;
    }
    m_entryCount = std::uint32_t(std::min(entries, mostEntries));
    m_work.varies = false;
    for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
        m_strokes.data()[i] = strokeRecord(scene, m_rules, scene.strokes[i]);
        m_work.varies |= !scene.strokes[i].oneColour || m_strokes.data()[i].fades;
    }
}

Fault CudaGradient::prepare(const FlatScene &scene)
{
    const View &view = scene.view;
    m_work.view = gradientView(view);
    m_work.width = view.width, m_work.height = view.height;
    m_work.columns = (view.width + gradientSide - 1) / gradientSide;
    m_work.rows = (view.height + gradientSide - 1) / gradientSide;
    for (int c = 0; c < 3; ++c)
        m_work.background[c] = float(scene.background[c]);
    m_work.byXi = scene.byXi;
    m_work.segmentCount = std::uint32_t(scene.segments.size()),
    m_work.strokeCount = std::uint32_t(scene.strokes.size());
    if (const Fault fault = inTurn([&] { return reserveAll(scene.segments.size(), m_segments); },
                                   [&] { return reserveAll(scene.strokes.size(), m_strokes); },
                                   [&] { return reserveAll(scene.segments.size(), m_deviceSegments); },
                                   [&] { return reserveAll(scene.strokes.size(), m_deviceStrokes); }))
        return fault;
    describe(scene);
    if (double(m_entryCount) >= mostEntries)
        return {Fault::Refused, "too many nodes reach too many tiles"};
    return inTurn([&] { return uploadRules(); }, [&] { return scene.paper ? uploadPaper(scene) : Fault(); },
                  [&] {
                      return m_device->upload(m_deviceSegments.data(), m_segments.data(),
                                              scene.segments.size() * sizeof(GradientSegment));
                  },
                  [&] {
                      return m_device->upload(m_deviceStrokes.data(), m_strokes.data(),
                                              scene.strokes.size() * sizeof(GradientStroke));
                  });
}

Fault CudaGradient::reserve(Loss loss)
{
    const auto tiles = std::size_t(m_work.columns) * std::size_t(m_work.rows);
    const std::size_t segments = m_work.segmentCount, strokes = m_work.strokeCount;
    const Fault fault =
        inTurn([&] { return reserveAll(m_rules.nodes.size(), m_nodes); }, [&] { return reserveAll(strokes, m_boxes); },
               [&] { return reserveAll(strokes, m_levels); }, [&] { return reserveAll(m_entryCount, m_entries); },
               [&] { return reserveAll(segments, m_sums); }, [&] { return reserveAll(segments, m_deviceSums); },
               [&] { return reserveAll(tiles, m_losses); }, [&] { return reserveAll(tiles, m_deviceLosses); },
               [&] { return m_status.reserve(gradientStatusWords); },
               [&] { return m_deviceStatus.reserve(gradientStatusWords); });
    m_work.segments = m_deviceSegments.data(), m_work.strokes = m_deviceStrokes.data();
    m_work.rules = m_deviceRules.data(), m_work.nodes = m_nodes.data(), m_work.boxes = m_boxes.data();
    m_work.levels = m_levels.data(), m_work.entries = m_entries.data();
    m_work.paper = m_scene.paper ? m_devicePaper.data() : nullptr;
    m_work.target = loss == Loss::Target ? m_target.data() : nullptr;
    m_work.byRgb = loss == Loss::Given ? m_byRgb.data() : nullptr;
    m_work.losses = m_deviceLosses.data(), m_work.status = m_deviceStatus.data(), m_work.sums = m_deviceSums.data();
    return fault;
}

Fault CudaGradient::reserveSlots()
{
    const std::size_t floats = m_slotStrokes * std::size_t(m_work.varies ? keptFloats<true> : keptFloats<false>);
    const auto tiles = std::size_t(m_work.columns) * std::size_t(m_work.rows);
    std::size_t warps =
        std::min({std::size_t(m_device->gradientWarps()), tiles, mostKeptBytes / (floats * sizeof(float))});
    warps = std::max<std::size_t>(warps, 1);
    Fault fault = m_kept.reserve(warps * floats);
    while (fault.kind == Fault::OutOfMemory && warps > 1) {
        warps /= 2;
        fault = m_kept.reserve(warps * floats);
    }
    if (!fault)
        fault = m_shown.reserve(warps * m_slotStrokes);
    m_work.kept = m_kept.data(), m_work.shown = m_shown.data();
    m_work.warps = std::uint32_t(warps), m_work.slotStrokes = m_slotStrokes;
    return fault;
}

Fault CudaGradient::attempt(Loss loss, bool &enough)
{
    const auto tiles = std::size_t(m_work.columns) * std::size_t(m_work.rows);
    const Fault fault =
        inTurn([&] { return reserveSlots(); },
               [&] { return m_device->clear(m_deviceStatus.data(), gradientStatusWords * sizeof(std::uint32_t)); },
               [&] { return m_device->findGradient(m_work); },
               [&] {
                   return m_device->download(m_status.data(), m_deviceStatus.data(),
                                             gradientStatusWords * sizeof(std::uint32_t));
               },
               [&] {
                   return loss == Loss::None ? Fault()
                                             : m_device->download(m_sums.data(), m_deviceSums.data(),
                                                                  m_work.segmentCount * sizeof(GradientSums));
               },
               [&] {
                   return loss == Loss::Target
                              ? m_device->download(m_losses.data(), m_deviceLosses.data(), tiles * sizeof(float))
                              : Fault();
               },
               [&] { return m_device->finish(&m_milliseconds); });
    if (fault)
        return fault;
    const std::uint32_t most = m_status.data()[mostStrokesShown];
    enough = most <= m_slotStrokes;
    if (!enough)
        m_slotStrokes = most + most / 4;
    return {};
}

bool CudaGradient::canDraw(const FlatScene &scene)
{
    return !scene.ground && std::none_of(scene.strokes.begin(), scene.strokes.end(), [](const FlatStroke &s) { return s.filled; });
}

Fault CudaGradient::run(Loss loss, bool picture)
{
    if (!canDraw(m_scene))
        return {Fault::Refused, "fills, and grounds that are pictures, have no gradient on the device"};
    if (const Fault fault = inTurn([&] { return prepare(m_scene); }, [&] { return reserve(loss); }))
        return fault;
    m_work.picture = nullptr;
    if (picture) {
        if (const Fault fault = reserveAll(std::size_t(m_work.width) * std::size_t(m_work.height) * 3, m_picture))
            return fault;
        m_work.picture = m_picture.data();
    }
    for (bool enough = false; !enough;)
        if (const Fault fault = attempt(loss, enough))
            return fault;
    if (loss != Loss::None)
        takeResults(loss);
    return {};
}

void CudaGradient::takeResults(Loss loss)
{
    m_loss = 0;
    if (loss == Loss::Target)
        for (std::size_t i = 0; i < std::size_t(m_work.columns) * std::size_t(m_work.rows); ++i)
            m_loss += double(m_losses.data()[i]);
    m_gradient.segments.assign(m_scene.segments.size(), {});
    m_gradient.strokes.assign(m_scene.strokes.size(), {});
    for (std::size_t i = 0; i < m_scene.strokes.size(); ++i) {
        const FlatStroke &stroke = m_scene.strokes[i];
        for (std::size_t k = stroke.first; k < stroke.first + stroke.count; ++k) {
            const GradientSums &sums = m_sums.data()[k];
            SegmentNumbers &out = m_gradient.segments[k],
                           &values = m_gradient.segments[stroke.oneColour ? stroke.first : k];
            std::copy_n(sums.x, 4, out.x), std::copy_n(sums.y, 4, out.y);
            out.density = sums.density, out.spread = sums.spread;
            for (int c = 0; c < 3; ++c)
                values.colour[c] += sums.value[c];
            values.opacity += sums.value[3], values.granulation += sums.value[4];
            for (int j = 0; j < 3; ++j)
                m_gradient.strokes[i].xi[j] += sums.xi[j];
        }
    }
}

Fault CudaGradient::draw(const FlatScene &scene)
{
    m_scene = scene;
    return run(Loss::None, true);
}

Fault CudaGradient::backward(std::span<const float> lossByRgb)
{
    if (const Fault fault =
            inTurn([&] { return reserveAll(lossByRgb.size(), m_byRgb); },
                   [&] { return m_device->upload(m_byRgb.data(), lossByRgb.data(), lossByRgb.size_bytes()); }))
        return fault;
    return run(Loss::Given, false);
}

Fault CudaGradient::drawAndDifferentiate(const FlatScene &scene, bool picture)
{
    m_scene = scene;
    if (m_targetSize != std::size_t(scene.view.width) * std::size_t(scene.view.height) * 3)
        return {Fault::Refused, "the target has not the size of the picture"};
    return run(Loss::Target, picture);
}

Fault CudaGradient::fetchPicture(std::vector<float> &out)
{
    out.resize(std::size_t(m_work.width) * std::size_t(m_work.height) * 3);
    return inTurn([&] { return m_device->download(out.data(), m_picture.data(), out.size() * sizeof(float)); },
                  [&] { return m_device->finish(nullptr); });
}

} // namespace suffuse
