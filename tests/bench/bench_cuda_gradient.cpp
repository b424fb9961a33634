// Times of the gradient of the picture, on the CPU and on a CUDA device, and how far these agree.
// bench_cuda_gradient [--backend cpu|cuda|both] [--size WxH] [--strokes N] [--runs N] [--only TEXT]
#include "render/cuda/cuda_gradient.h"
#include "render/gradient/scene_gradient.h"
#include "tests/render/flat_scenes.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTextStream>

#include <algorithm>
#include <bit>
#include <cstring>

using namespace suffuse;
using namespace suffuse::test;

namespace {

struct BenchScene {
    const char *name;
    SceneKind kind;
};

/// Strokes of three segments: fine ones, which cover the picture about twice, and broad ones, about tenfold.
std::vector<BenchScene> benchScenes()
{
    SceneKind fine, broad;
    fine.least = 3, fine.greatest = 12, fine.length = 40;
    broad.least = 8, broad.greatest = 32, broad.length = 80;
    std::vector<BenchScene> scenes;
    for (const auto &[style, names] :
         {std::pair{StyleKind::Uniform, std::pair{"fine, uniform", "broad, uniform"}},
          std::pair{StyleKind::Feathering, std::pair{"fine, feathering", "broad, feathering"}},
          std::pair{StyleKind::Edge, std::pair{"fine, edge", "broad, edge"}}}) {
        fine.style = broad.style = style;
        scenes.push_back({names.first, fine});
        scenes.push_back({names.second, broad});
    }
    SceneKind varying = fine;
    varying.style = StyleKind::Uniform, varying.oneColour = false;
    scenes.push_back({"fine, uniform, colours vary", varying});
    return scenes;
}

/// Moves all strokes a little, as a step of a fit does.
void move(FlatScene &scene, int step)
{
    for (std::size_t k = 0; k < scene.segments.size(); ++k)
        for (int j = 0; j < 4; ++j)
            scene.segments[k].x[j] += 0.01 * ((int(k) + step) % 7 - 3),
                scene.segments[k].y[j] += 0.01 * ((int(k) + step) % 5 - 2);
}

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

std::vector<double> numbersOf(FlatScene &scene, const FlatGradient &by)
{
    std::vector<double> out;
    forEachNumber(scene, by, [&](double, double d, double scale) { out.push_back(d * scale); });
    return out;
}

/// |a − b| / |a|.
double distance(const std::vector<double> &a, const std::vector<double> &b)
{
    double all = 0, differences = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        all += a[i] * a[i], differences += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(differences / all);
}

int differingBits(const std::vector<double> &a, const std::vector<double> &b)
{
    int bits = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        bits += std::popcount(std::bit_cast<std::uint64_t>(a[i]) ^ std::bit_cast<std::uint64_t>(b[i]));
    return bits;
}

class GradientBench {
public:
    GradientBench(int width, int height, int strokes, int runs)
        : m_width(width), m_height(height), m_strokes(strokes), m_runs(runs)
    {
        FlatScene other = randomScene(99, strokes, width, height, benchScenes().front().kind);
        SceneGradient<float> gradient;
        gradient.choose(other);
        const std::span<const float> picture = gradient.draw(other);
        m_target.assign(picture.begin(), picture.end());
    }

    FlatScene scene(const BenchScene &of) const
    {
        FlatScene scene = randomScene(1, m_strokes, m_width, m_height, of.kind);
        scene.byXi = false;
        return scene;
    }

    /// Times the CPU.
    void cpu(const BenchScene &of)
    {
        FlatScene scene = this->scene(of);
        SceneGradient<float> gradient;
        gradient.choose(scene);
        std::vector<double> times;
        for (int i = 0; i < m_runs; ++i) {
            move(scene, i);
            QElapsedTimer timer;
            timer.start();
            onCpu(gradient, scene);
            times.push_back(1e-6 * double(timer.nsecsElapsed()));
        }
        m_out << QString("%1  cpu    forward and backward %2 ms\n").arg(of.name, -28).arg(median(times), 0, 'f', 3)
              << Qt::flush;
    }

    /// Times a device, and compares it with the CPU and with itself. Returns whether they agree.
    bool cuda(const BenchScene &of, const std::shared_ptr<cuda::Device> &device)
    {
        FlatScene scene = this->scene(of);
        CudaGradient gradient(device);
        gradient.choose(scene);
        cuda::Fault fault = gradient.setTarget(m_target);
        std::vector<double> whole, programs, forward;
        for (int i = -3; i < m_runs && !fault; ++i) {
            move(scene, i + 3);
            if ((fault = gradient.draw(scene)))
                break;
            const double drawing = gradient.milliseconds();
            QElapsedTimer timer;
            timer.start();
            fault = gradient.drawAndDifferentiate(scene);
            const double time = 1e-6 * double(timer.nsecsElapsed());
            if (i < 0) // the first calls make room
                continue;
            whole.push_back(time), programs.push_back(gradient.milliseconds()), forward.push_back(drawing);
        }
        if (fault) {
            m_out << of.name << ": " << fault.what.c_str() << "\n";
            return false;
        }
        return report(of, scene, gradient, median(forward), median(programs), median(whole));
    }

private:
    const FlatGradient &onCpu(SceneGradient<float> &gradient, const FlatScene &scene) const
    {
        return gradient.drawAndDifferentiate(scene,
                                             [&](std::size_t first, std::size_t count, const float *rgb, float *by) {
                                                 for (std::size_t i = 0; i < 3 * count; ++i)
                                                     by[i] = 2 * (rgb[i] - m_target[3 * first + i]);
                                             });
    }

    bool report(const BenchScene &of, FlatScene &scene, CudaGradient &gradient, double forward, double programs,
                double whole)
    {
        const auto first = numbersOf(scene, gradient.gradient());
        const double firstLoss = gradient.loss();
        bool again = !gradient.drawAndDifferentiate(scene, true);
        const int bits = differingBits(first, numbersOf(scene, gradient.gradient()));
        again = again && gradient.loss() == firstLoss;
        SceneGradient<float> cpu;
        cpu.choose(scene);
        const auto expected = numbersOf(scene, onCpu(cpu, scene));
        const double apart = distance(expected, first);
        std::vector<float> picture;
        again = !gradient.fetchPicture(picture) && again;
        double worst = 0;
        for (std::size_t i = 0; i < picture.size(); ++i)
            worst = std::max(worst, std::abs(double(picture[i]) - double(cpu.picture()[i])));
        m_out << QString("%1  cuda   forward %2 ms, forward and backward %3 ms on the device, %4 ms in all; "
                         "CPU = CUDA within %5 (picture %6); twice: %7 differing bits%8\n")
                     .arg(of.name, -28)
                     .arg(forward, 0, 'f', 3)
                     .arg(programs, 0, 'f', 3)
                     .arg(whole, 0, 'f', 3)
                     .arg(apart, 0, 'e', 1)
                     .arg(worst, 0, 'e', 1)
                     .arg(bits)
                     .arg(again ? "" : ", another loss")
              << Qt::flush;
        return again && bits == 0 && apart < 1e-3;
    }

    int m_width, m_height, m_strokes, m_runs;
    std::vector<float> m_target;
    QTextStream m_out{stdout};
};

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.addOptions({{"backend", "cpu, cuda or both.", "name", "both"},
                       {"size", "Width and height in pixels.", "WxH", "2040x1344"},
                       {"strokes", "Strokes of three segments.", "count", "2048"},
                       {"runs", "Of each scene; the median is reported.", "count", "25"},
                       {"only", "Scenes whose name has this text.", "text"}});
    parser.addHelpOption();
    parser.process(app);
    const QStringList size = parser.value("size").split('x');
    if (size.size() != 2 || size[0].toInt() < 1 || size[1].toInt() < 1)
        parser.showHelp(2);
    QTextStream out(stdout);
    const QString backend = parser.value("backend");
    std::string why;
    const std::shared_ptr<cuda::Device> device = backend == "cpu" ? nullptr : cuda::openDevice(0, why);
    if (device)
        out << device->name().c_str() << "\n" << Qt::flush;
    else if (backend != "cpu")
        out << "skipped: no CUDA device: " << why.c_str() << "\n" << Qt::flush;
    GradientBench bench(size[0].toInt(), size[1].toInt(), std::max(parser.value("strokes").toInt(), 1),
                        std::max(parser.value("runs").toInt(), 1));
    bool agree = true;
    for (const BenchScene &scene : benchScenes()) {
        if (!QString(scene.name).contains(parser.value("only")))
            continue;
        if (backend != "cuda")
            bench.cpu(scene);
        if (device)
            agree = bench.cuda(scene, device) && agree;
    }
    return agree ? 0 : 1;
}
