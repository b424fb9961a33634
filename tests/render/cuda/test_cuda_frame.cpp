// The picture that stays on a CUDA device: what is shown, when, and what of it is copied.
#include "render/cuda/cuda_frame.h"
#include "tests/render/cuda/emulated_device.h"

#include <QTest>

using namespace suffuse;

namespace {

constexpr int width = 40, height = 30;

/// A texture in memory that counts its copies.
struct FakeTexture {
    std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(width * height, 7);
    int registered = 0;
    int rectangles = 0;
    bool fails = false;
};

class FakeGlTexture : public cuda::GlTexture {
public:
    explicit FakeGlTexture(FakeTexture &texture) : m_texture(texture) { ++m_texture.registered; }
    ~FakeGlTexture() override { --m_texture.registered; }
    cuda::Fault copyFrom(const std::uint32_t *picture, int rowPixels, const int (*rects)[4], int count) override
    {
        if (m_texture.fails)
            return {cuda::Fault::Lost, "the context is gone"};
        for (int i = 0; i < count; ++i)
            for (int y = rects[i][1]; y < rects[i][1] + rects[i][3]; ++y)
                for (int x = rects[i][0]; x < rects[i][0] + rects[i][2]; ++x)
                    m_texture.pixels[std::size_t(y * width + x)] = picture[y * rowPixels + x];
        m_texture.rectangles += count;
        return {};
    }

private:
    FakeTexture &m_texture;
};

/// A device that draws the screen.
class DisplayDevice : public test::EmulatedDevice {
public:
    using EmulatedDevice::EmulatedDevice;
    std::unique_ptr<cuda::GlTexture> registerTexture(unsigned number, cuda::Fault &fault) override
    {
        if (number != 1) {
            fault.what = "another device draws this OpenGL context";
            return nullptr;
        }
        return std::make_unique<FakeGlTexture>(texture);
    }
    FakeTexture texture;
};

/// Pixel (x, y) of the k-th picture.
std::uint32_t pixel(int x, int y, int k)
{
    return 0xff000000u + std::uint32_t(k * 10'000 + y * width + x);
}

/// Renders the k-th picture, in these rectangles.
void draw(CudaFrame &frame, const std::vector<PixelRect> &rects, int k)
{
    for (const PixelRect &r : rects)
        for (int y = r.y; y < r.y + r.height; ++y)
            for (int x = r.x; x < r.x + r.width; ++x)
                frame.picture()[y * width + x] = pixel(x, y, k);
}

/// Pixels of the texture that are not of the k-th picture within the rectangles and of the others' elsewhere.
int wrongPixels(const FakeTexture &texture, const std::vector<PixelRect> &rects, int k, int elsewhere)
{
    int wrong = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            bool inside = false;
            for (const PixelRect &r : rects)
                inside |= x >= r.x && x < r.x + r.width && y >= r.y && y < r.y + r.height;
            wrong += texture.pixels[std::size_t(y * width + x)] != pixel(x, y, inside ? k : elsewhere);
        }
    return wrong;
}

const std::vector<PixelRect> all{PixelRect{0, 0, width, height}};

} // namespace

class TestCudaFrame : public QObject {
    Q_OBJECT

private slots:
    void showsWhatWasPublished_data()
    {
        QTest::addColumn<int>("tiles");
        QTest::newRow("one") << 1;
        QTest::newRow("a few") << 4;
        QTest::newRow("many at once") << 9;
    }

    void showsWhatWasPublished()
    {
        QFETCH(int, tiles);
        auto device = std::make_shared<DisplayDevice>();
        std::string why;
        const auto frame = makeCudaFrame(device, width, height, why);
        QVERIFY2(frame, why.c_str());
        QCOMPARE(frame->width(), width);
        QCOMPARE(frame->height(), height);
        auto link = frame->link(1);
        QVERIFY2(bool(link), qPrintable(link.error()));
        draw(*frame, all, 1);
        QVERIFY(bool(frame->publish(all)));
        QVERIFY(bool(frame->copyTo(**link, all)));
        QCOMPARE(wrongPixels(device->texture, all, 1, 1), 0);

        std::vector<PixelRect> dirty;
        for (int i = 0; i < tiles; ++i)
            dirty.push_back({4 * i, 3 * i, 4, 3});
        draw(*frame, dirty, 2);
        QVERIFY(bool(frame->copyTo(**link, all))); // not published yet
        QCOMPARE(wrongPixels(device->texture, all, 1, 1), 0);
        QVERIFY(bool(frame->publish(dirty)));
        device->texture.rectangles = 0;
        QVERIFY(bool(frame->copyTo(**link, dirty)));
        QCOMPARE(wrongPixels(device->texture, dirty, 2, 1), 0);
        QVERIFY(device->texture.rectangles <= 4);
        device->texture.rectangles = 0;
        QVERIFY(bool(frame->copyTo(**link, {})) && bool(frame->publish({})));
        QCOMPARE(device->texture.rectangles, 0);
    }

    void saysWhyNot()
    {
        auto device = std::make_shared<DisplayDevice>();
        std::string why;
        const auto frame = makeCudaFrame(device, width, height, why);
        QVERIFY2(frame, why.c_str());
        const auto other = frame->link(2);
        QVERIFY(!other);
        QCOMPARE(other.error(), QString("another device draws this OpenGL context"));
        auto link = frame->link(1);
        QVERIFY(bool(link));
        device->texture.fails = true;
        QCOMPARE(frame->copyTo(**link, all).error(), QString("the context is gone"));
    }

    void needsRoomForTwo()
    {
        constexpr std::size_t one = std::size_t(width) * height * 4;
        auto device = std::make_shared<DisplayDevice>(one + one / 2);
        std::string why;
        QVERIFY(!makeCudaFrame(device, width, height, why));
        QVERIFY(!why.empty());
        QVERIFY(device->freeMemory() >= one + one / 2); // the first one was given back
    }

    void theDeviceOutlivesTheLink()
    {
        auto device = std::make_shared<DisplayDevice>();
        const std::weak_ptr<DisplayDevice> alive = device;
        std::string why;
        auto frame = makeCudaFrame(std::move(device), width, height, why);
        auto link = frame->link(1);
        QVERIFY(bool(link));
        frame.reset();
        QVERIFY(!alive.expired());
        QCOMPARE(alive.lock()->texture.registered, 1);
        link->reset();
        QVERIFY(alive.expired());
    }
};

QTEST_GUILESS_MAIN(TestCudaFrame)
#include "test_cuda_frame.moc"
