#include "render/cuda/device_nodes.h"

#include "render/nodes/ellipse_bounds.h"
#include "render/nodes/span_rule.h"

namespace suffuse::cuda {

namespace {

/// So many segments are built together at most, unless a stroke has more. They take some 40 MB of the device's memory.
constexpr std::size_t mostSegments = 65536;
/// There is room for so many Level 0 nodes at least, and at most. What finds none is left to the host.
constexpr std::size_t fewestNodes = 4096, mostNodes = std::size_t(1) << 21;

} // namespace

DeviceNodes::DeviceNodes(std::shared_ptr<Device> device, std::size_t worthwhile)
    : m_device(std::move(device)), m_worthwhile(worthwhile), m_panels(*m_device), m_spans(*m_device),
      m_planes(*m_device), m_segments(*m_device), m_jobs(*m_device), m_deviceSegments(*m_device),
      m_deviceJobs(*m_device), m_fine(*m_device), m_length(*m_device), m_turning(*m_device), m_pieces(*m_device),
      m_leaves(*m_device), m_deviceStatus(*m_device), m_devicePlaces(*m_device), m_devicePlain(*m_device),
      m_deviceWindows(*m_device), m_deviceMerged(*m_device), m_status(*m_device), m_places(*m_device),
      m_plain(*m_device), m_windows(*m_device), m_merged(*m_device)
{}

void DeviceNodes::release()
{
    m_prepared = false;
    m_panels.release(), m_spans.release(), m_planes.release();
    m_segments.release(), m_jobs.release(), m_deviceSegments.release(), m_deviceJobs.release();
    m_fine.release(), m_length.release(), m_turning.release(), m_pieces.release(), m_leaves.release();
    m_deviceStatus.release(), m_devicePlaces.release(), m_devicePlain.release();
    m_deviceWindows.release(), m_deviceMerged.release();
    m_status.release(), m_places.release(), m_plain.release(), m_windows.release(), m_merged.release();
}

void DeviceNodes::makeReady()
{
    constexpr std::size_t segments = 30000, nodes = 400000, plain = 30000, windows = 16000, merged = 150000;
    Fault fault = prepare();
    if (!fault)
        fault = reserve(segments, segments / 8, nodes);
    if (!fault)
        fault = reserveResults(segments, plain, windows, merged);
    if (fault.kind == Fault::OutOfMemory)
        release();
}

Fault DeviceNodes::prepare()
{
    if (m_prepared)
        return {};
    for (const Fault &fault :
         {m_panels.reserve(1), m_spans.reserve(1), m_deviceStatus.reserve(nodeStatusWords),
          m_status.reserve(nodeStatusWords), m_planes.reserve(std::size_t(planeSize) * mergeWorkers)})
        if (fault)
            return fault;
    if (Fault fault = m_device->upload(m_panels.data(), &panelTables(), sizeof(panels::Tables)))
        return fault;
    if (Fault fault = m_device->upload(m_spans.data(), &spanTables(), sizeof(spans::Tables)))
        return fault;
    m_prepared = true;
    return {};
}

Fault DeviceNodes::reserve(std::size_t segments, std::size_t jobs, std::size_t nodes)
{
    const std::size_t windows = segments + nodes / spans::fewest + 1;
    for (const Fault &fault :
         {m_segments.reserve(segments), m_jobs.reserve(jobs), m_deviceSegments.reserve(segments),
          m_deviceJobs.reserve(jobs), m_fine.reserve(nodes), m_length.reserve(nodes), m_turning.reserve(nodes),
          m_pieces.reserve(segments * keptPieces), m_leaves.reserve(segments), m_devicePlaces.reserve(segments),
          m_devicePlain.reserve(nodes), m_deviceWindows.reserve(windows), m_deviceMerged.reserve(nodes)})
        if (fault)
            return fault;
    m_work.segments = m_deviceSegments.data();
    m_work.jobs = m_deviceJobs.data();
    m_work.jobCount = std::uint32_t(jobs);
    m_work.panels = m_panels.data();
    m_work.spans = m_spans.data();
    m_work.places = m_devicePlaces.data();
    m_work.pieces = m_pieces.data();
    m_work.plain = m_devicePlain.data();
    m_work.fine = m_fine.data();
    m_work.plainRoom = m_work.fineRoom = std::uint32_t(nodes);
    m_work.length = m_length.data();
    m_work.turning = m_turning.data();
    m_work.leaves = m_leaves.data();
    m_work.windows = m_deviceWindows.data();
    m_work.merged = m_deviceMerged.data();
    m_work.planes = m_planes.data();
    m_work.status = m_deviceStatus.data();
    return {};
}

Fault DeviceNodes::run(std::size_t segments, std::size_t jobs)
{
    if (Fault fault = m_device->clear(m_deviceStatus.data(), nodeStatusWords * sizeof(std::uint32_t)))
        return fault;
    if (Fault fault = m_device->upload(m_deviceSegments.data(), m_segments.data(), segments * sizeof(SegmentRecord)))
        return fault;
    if (Fault fault = m_device->upload(m_deviceJobs.data(), m_jobs.data(), jobs * sizeof(NodeJob)))
        return fault;
    if (Fault fault = m_device->buildNodes(m_work))
        return fault;
    return m_device->download(m_status.data(), m_deviceStatus.data(), nodeStatusWords * sizeof(std::uint32_t));
}

Fault DeviceNodes::reserveResults(std::size_t segments, std::size_t plain, std::size_t windows, std::size_t merged)
{
    for (const Fault &fault :
         {m_places.reserve(segments), m_plain.reserve(plain), m_windows.reserve(windows), m_merged.reserve(merged)})
        if (fault)
            return fault;
    return {};
}

Fault DeviceNodes::fetch(std::size_t segments)
{
    const std::uint32_t *status = m_status.data();
    const std::size_t plain = std::min(status[plainTaken], m_work.plainRoom), windows = status[windowsTaken];
    const std::size_t merged = status[mergedTaken];
    if (Fault fault = reserveResults(segments, plain, windows, merged))
        return fault;
    for (const Fault &fault :
         {m_device->download(m_places.data(), m_devicePlaces.data(), segments * sizeof(NodePlace)),
          m_device->download(m_plain.data(), m_devicePlain.data(), plain * sizeof(PlainNode)),
          m_device->download(m_windows.data(), m_deviceWindows.data(), windows * sizeof(MergedWindow)),
          m_device->download(m_merged.data(), m_deviceMerged.data(), merged * sizeof(MergedNode))})
        if (fault)
            return fault;
    return {};
}

Fault DeviceNodes::buildBatch(const std::vector<Planned> &batch, Threads threads,
                              std::span<std::shared_ptr<const StrokeNodes>> out)
{
    if (batch.empty())
        return {};
    const Planned &last = batch.back();
    const std::size_t segments = last.segment + last.stroke->segments.size(),
                      jobs = last.job + last.stroke->runs.size();
    if (jobs == 0)
        return {};
    if (Fault fault = prepare())
        return fault;
    double expected = fewestNodes;
    for (const Planned &p : batch)
        expected += p.stroke->nodes;
    const auto nodes = std::size_t(std::min(expected, double(mostNodes)));
    if (Fault fault = reserve(segments, jobs, nodes))
        return fault;
    constexpr std::size_t share = 8;
    const std::size_t shares = (batch.size() + share - 1) / share;
    const auto forEach = [&](const auto &use) {
        parallelFor(shares, threads, [&](std::size_t k) {
            for (std::size_t i = k * share; i < std::min((k + 1) * share, batch.size()); ++i)
                use(batch[i]);
        });
    };
    forEach([&](const Planned &p) {
        writeRecords(*p.stroke, p.segment, m_segments.data() + p.segment, m_jobs.data() + p.job);
    });
    Fault fault = run(segments, jobs);
    // What was asked for reads and writes host memory until then.
    Fault waited = m_device->finish(nullptr);
    if (!fault && !waited) {
        fault = fetch(segments);
        waited = m_device->finish(nullptr);
    }
    if (fault || waited)
        return fault ? fault : waited;
    m_windowAt.resize(std::min(m_status.data()[fineTaken], m_work.fineRoom));
    for (std::uint32_t i = 0; i < m_status.data()[windowsTaken]; ++i)
        m_windowAt[m_windows.data()[i].begin] = i;
    const BulkResults results{m_places.data(), m_plain.data(), m_windows.data(), m_merged.data(), m_windowAt.data()};
    forEach([&](const Planned &p) { out[p.index] = bulkNodes(*p.stroke, p.segment, results); });
    return {};
}

std::vector<std::shared_ptr<const StrokeNodes>> DeviceNodes::build(std::span<const StrokePtr> strokes, Microseconds T,
                                                                   int octave, const Rect &clip, Threads threads)
{
    std::vector<std::shared_ptr<const StrokeNodes>> out(strokes.size());
    Fault fault;
    for (std::size_t from = 0, to = 0; from < strokes.size() && !fault; from = to) {
        for (std::size_t segments = 0; to < strokes.size(); ++to) {
            segments += strokes[to]->segments.size();
            if (segments > mostSegments && to > from)
                break;
        }
        fault = buildBatch(plan(strokes.subspan(from, to - from), T, octave, clip, threads), threads,
                           std::span(out).subspan(from, to - from));
    }
    if (fault.kind == Fault::OutOfMemory)
        release();
    return out;
}

std::vector<DeviceNodes::Planned> DeviceNodes::plan(std::span<const StrokePtr> strokes, Microseconds T, int octave,
                                                    const Rect &clip, Threads threads)
{
    if (m_plans.size() < strokes.size())
        m_plans.resize(strokes.size());
    std::vector<char> planned(strokes.size(), 0);
    constexpr std::size_t share = 8;
    parallelFor((strokes.size() + share - 1) / share, threads, [&](std::size_t k) {
        for (std::size_t i = k * share; i < std::min((k + 1) * share, strokes.size()); ++i)
            planned[i] = planBulk(*strokes[i], T, octave, clip, m_plans[i]);
    });
    std::vector<Planned> batch;
    std::size_t segments = 0, jobs = 0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!planned[i])
            continue;
        batch.push_back({i, &m_plans[i], std::uint32_t(segments), std::uint32_t(jobs)});
        segments += m_plans[i].segments.size(), jobs += m_plans[i].runs.size();
    }
    return batch;
}

} // namespace suffuse::cuda
