#include "app/panels/strokes/stroke_thumbnails.h"

#include "model/painting/influence.h"
#include "render/backends.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
constexpr std::size_t mostWanted = 64; ///< Older wishes are dropped, since their rows have been scrolled past.
constexpr double thumbnailMargin = 0.04;
} // namespace

/// Draws the pictures; it lives on the worker's thread.
class StrokeThumbnails::Maker {
public:
    QImage make(const StrokePtr &stroke, double ratio)
    {
        if (!m_renderer) {
            auto made = makeRenderer({.backend = Backend::Cpu, .threads = 1});
            if (!made)
                return {};
            m_renderer = std::move(*made);
        }
        auto painting = std::make_shared<Painting>();
        auto shown = std::make_shared<Stroke>(*stroke);
        shown->visible = true;
        shown->group = 0;
        painting->strokes.push_back(shown);
        Rect box;
        for (const Segment &segment : stroke->segments)
            box = box.united(stroke->cubicOf(segment).controlBox().grown(1.2 * segment.spread(segment.driesAt())));
        RenderRequest request;
        request.painting = painting;
        request.time = painting->end();
        request.transparent = true;
        request.view.width = int(std::lround(size.width() * ratio));
        request.view.height = int(std::lround(size.height() * ratio));
        request.view.centre = box.centre();
        request.view.scale =
            std::clamp((1 - 2 * thumbnailMargin) * std::min(request.view.width / std::max(box.width(), 1e-9),
                                                            request.view.height / std::max(box.height(), 1e-9)),
                       1e-3, 1e9);
        Picture8 picture;
        m_renderer->invalidate();
        if (!m_renderer->render(request, picture))
            return {};
        QImage image = QImage(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                              picture.width * 4, QImage::Format_ARGB32)
                           .copy();
        image.setDevicePixelRatio(ratio);
        return image;
    }

private:
    std::unique_ptr<Renderer> m_renderer;
};

StrokeThumbnails::StrokeThumbnails(QObject *parent) : QObject(parent), m_maker(std::make_shared<Maker>())
{
    m_thread.setMaxThreadCount(1);
}

StrokeThumbnails::~StrokeThumbnails()
{
    m_thread.waitForDone();
}

QImage StrokeThumbnails::of(const StrokePtr &stroke, double ratio, bool quiet)
{
    const Entry *entry = m_known.object(stroke->id);
    if (entry && entry->stroke == stroke && entry->image.devicePixelRatio() == ratio)
        return entry->image;
    const bool asked = m_running == stroke || std::any_of(m_wanted.begin(), m_wanted.end(),
                                                          [&](const auto &wish) { return wish.first == stroke; });
    if (!quiet && !asked) {
        if (m_wanted.size() >= mostWanted)
            m_wanted.erase(m_wanted.begin());
        m_wanted.emplace_back(stroke, ratio);
        startNext();
    }
    return entry ? entry->image : QImage();
}

void StrokeThumbnails::startNext()
{
    if (m_running || m_wanted.empty())
        return;
    const auto [stroke, ratio] = m_wanted.back();
    m_wanted.pop_back();
    m_running = stroke;
    m_thread.start([this, stroke = stroke, ratio = ratio, maker = m_maker] {
        const QImage image = maker->make(stroke, ratio);
        QMetaObject::invokeMethod(
            this, [this, stroke, image] { take(stroke, image); }, Qt::QueuedConnection);
    });
}

void StrokeThumbnails::take(const StrokePtr &stroke, const QImage &image)
{
    m_running = nullptr;
    m_known.insert(stroke->id, new Entry{stroke, image});
    emit ready(stroke->id);
    startNext();
}

} // namespace suffuse
