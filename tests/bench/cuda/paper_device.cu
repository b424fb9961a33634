#include "tests/bench/cuda/as_written.cuh"
#include "tests/bench/cuda/paper_device.h"
#include "tests/bench/cuda/port.cuh"

#include <algorithm>
#include <cmath>

namespace suffuse::baseline {

namespace {

/// Device memory that is given back at the end.
template <class T>
class Memory {
public:
    Memory() = default;
    Memory(const Memory &) = delete;
    Memory &operator=(const Memory &) = delete;
    ~Memory() { cudaFree(m_data); }
    cudaError_t allocate(std::size_t count)
    {
        return cudaMalloc(reinterpret_cast<void **>(&m_data), std::max<std::size_t>(count, 1) * sizeof(T));
    }
    cudaError_t upload(const std::vector<T> &from)
    {
        const cudaError_t error = allocate(from.size());
        return error ? error : cudaMemcpy(m_data, from.data(), from.size() * sizeof(T), cudaMemcpyHostToDevice);
    }
    T *get() const { return m_data; }

private:
    T *m_data = nullptr;
};

/// Keeps the first error.
class Check {
public:
    void operator()(cudaError_t error)
    {
        if (m_error == cudaSuccess)
            m_error = error;
    }
    bool isGood(std::string &why) const
    {
        if (m_error != cudaSuccess)
            why = cudaGetErrorString(m_error);
        return m_error == cudaSuccess;
    }

private:
    cudaError_t m_error = cudaSuccess;
};

int rounded(int pixels, int side)
{
    return (pixels + side - 1) / side;
}

/// Room that the longest macro-tile's list takes at most: segments whose boxes meet it.
std::uint32_t listRoom(const PaperScene &scene)
{
    const int columns = rounded(scene.width, macroSide), rows = rounded(scene.height, macroSide);
    std::vector<std::uint32_t> counts(std::size_t(columns) * rows, 0);
    for (const QuadratureRecord &s : scene.quadratures) {
        const auto cell = [](float at, int cells) { return std::clamp(int(std::floor(at / macroSide)), 0, cells - 1); };
        const int right = cell(s.middleX + s.reach + 1, columns), bottom = cell(s.middleY + s.reach + 1, rows);
        for (int y = cell(s.middleY - s.reach - 1, rows); y <= bottom; ++y)
            for (int x = cell(s.middleX - s.reach - 1, columns); x <= right; ++x)
                ++counts[std::size_t(y) * columns + x];
    }
    return *std::max_element(counts.begin(), counts.end());
}

class Drawing : public PaperOnDevice {
public:
    /// Uploads the scene; false: `why` says why not.
    bool prepare(const PaperScene &scene, std::string &why);
    std::string deviceName() const override { return m_name; }
    double draw(PaperKernel kernel, int polynomials, std::string &why) override;
    std::vector<float> picture(std::string &why) override;
    ~Drawing() override;

private:
    float3 background() const { return make_float3(m_background[0], m_background[1], m_background[2]); }
    template <int points>
    void drawAsWritten();
    template <int points>
    void drawPort(int polynomials);

    std::string m_name;
    int m_width = 0, m_height = 0, m_points = 0;
    float m_background[3] = {};
    std::vector<ShadeRecord> m_strokes; ///< what the launches are given
    Memory<CurveRecord> m_curves;
    Memory<QuadratureRecord> m_quadratures;
    Memory<ShadeRecord> m_shades;
    Memory<float4> m_circles;
    Memory<float4> m_canvas;
    Memory<std::uint32_t> m_lists, m_counts;
    int m_segments = 0;
    std::uint32_t m_room = 0;
    cudaEvent_t m_begin = nullptr, m_end = nullptr;
};

Drawing::~Drawing()
{
    if (m_begin)
        cudaEventDestroy(m_begin);
    if (m_end)
        cudaEventDestroy(m_end);
}

bool Drawing::prepare(const PaperScene &scene, std::string &why)
{
    Check check;
    cudaDeviceProp properties{};
    check(cudaGetDeviceProperties(&properties, 0));
    if (!check.isGood(why))
        return false;
    m_name = properties.name;
    m_width = scene.width;
    m_height = scene.height;
    m_points = scene.points;
    m_segments = int(scene.quadratures.size());
    std::copy(scene.background, scene.background + 3, m_background);
    m_strokes = scene.strokes;
    m_room = listRoom(scene);
    std::vector<float4> circles;
    for (const QuadratureRecord &s : scene.quadratures)
        circles.push_back(make_float4(s.middleX, s.middleY, s.reach, 0));
    const std::size_t macros = std::size_t(rounded(m_width, macroSide)) * rounded(m_height, macroSide);
    check(m_curves.upload(scene.curves));
    check(m_quadratures.upload(scene.quadratures));
    check(m_shades.upload(scene.strokes));
    check(m_circles.upload(circles));
    check(m_canvas.allocate(std::size_t(m_width) * m_height));
    check(m_lists.allocate(macros * m_room));
    check(m_counts.allocate(macros));
    check(cudaMemcpyToSymbol(ruleX, scene.ruleX, sizeof scene.ruleX));
    check(cudaMemcpyToSymbol(ruleWeight, scene.ruleWeight, sizeof scene.ruleWeight));
    check(cudaEventCreate(&m_begin));
    check(cudaEventCreate(&m_end));
    return check.isGood(why);
}

template <int points>
void Drawing::drawAsWritten()
{
    const int pixels = m_width * m_height, threads = 256;
    const dim3 block(32, 8), grid(rounded(m_width, 32), rounded(m_height, 8));
    clearCanvas<<<rounded(pixels, threads), threads>>>(m_canvas.get(), pixels, background());
    for (const ShadeRecord &stroke : m_strokes)
        paintStroke<points><<<grid, block>>>(m_curves.get(), stroke, m_canvas.get(), m_width, m_height);
    finishCanvas<<<rounded(pixels, threads), threads>>>(m_canvas.get(), pixels);
}

template <int points>
void Drawing::drawPort(int polynomials)
{
    const int macroColumns = rounded(m_width, macroSide), macros = macroColumns * rounded(m_height, macroSide);
    listSegments<<<macros, listThreads>>>(m_circles.get(), m_segments, macroColumns, m_lists.get(), m_room,
                                          m_counts.get());
    const PortScene scene{m_circles.get(), m_quadratures.get(), m_shades.get(), m_lists.get(), m_counts.get(),
                          m_room,          macroColumns,        m_width,        m_height,      background()};
    const dim3 grid(rounded(m_width, tileSide), rounded(m_height, tileSide));
    if (polynomials == 0)
        paintTile<points, 0><<<grid, tileThreads>>>(scene, m_canvas.get());
    else if (polynomials == 1)
        paintTile<points, 1><<<grid, tileThreads>>>(scene, m_canvas.get());
    else
        paintTile<points, 2><<<grid, tileThreads>>>(scene, m_canvas.get());
}

double Drawing::draw(PaperKernel kernel, int polynomials, std::string &why)
{
    Check check;
    check(cudaEventRecord(m_begin));
    if (kernel == PaperKernel::AsWritten)
        m_points == 5 ? drawAsWritten<5>() : drawAsWritten<8>();
    else
        m_points == 5 ? drawPort<5>(polynomials) : drawPort<8>(polynomials);
    check(cudaGetLastError());
    check(cudaEventRecord(m_end));
    check(cudaEventSynchronize(m_end));
    float milliseconds = 0;
    check(cudaEventElapsedTime(&milliseconds, m_begin, m_end));
    return check.isGood(why) ? double(milliseconds) : -1;
}

std::vector<float> Drawing::picture(std::string &why)
{
    std::vector<float> out(std::size_t(m_width) * m_height * 4);
    Check check;
    check(cudaMemcpy(out.data(), m_canvas.get(), out.size() * sizeof(float), cudaMemcpyDeviceToHost));
    return check.isGood(why) ? out : std::vector<float>();
}

} // namespace

std::unique_ptr<PaperOnDevice> paperOnDevice(const PaperScene &scene, std::string &why)
{
    int count = 0;
    Check check;
    check(cudaGetDeviceCount(&count));
    if (!check.isGood(why))
        return nullptr;
    auto drawing = std::make_unique<Drawing>();
    return drawing->prepare(scene, why) ? std::move(drawing) : nullptr;
}

} // namespace suffuse::baseline
