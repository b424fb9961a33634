#include "app/window/free_hand.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/tool.h"
#include "app/session/editor.h"

namespace suffuse {

namespace {

bool isInHand(CanvasWidget &canvas)
{
    return (canvas.tool() && canvas.tool()->isBusy()) || canvas.editor().isDragging();
}

} // namespace

void whenHandIsFree(CanvasWidget &canvas, QObject &context, const std::function<void()> &function)
{
    if (!isInHand(canvas)) {
        function();
        return;
    }
    // The object lives until the function has been called, and ends both connections then.
    auto *waiting = new QObject(&context);
    const auto tryAgain = [&canvas, waiting, function] {
        if (isInHand(canvas))
            return;
        waiting->deleteLater();
        QObject::disconnect(&canvas, nullptr, waiting, nullptr);
        QObject::disconnect(&canvas.editor(), nullptr, waiting, nullptr);
        function();
    };
    // What has ended the work goes on in its own event.
    QObject::connect(&canvas, &CanvasWidget::busyChanged, waiting, tryAgain, Qt::QueuedConnection);
    QObject::connect(&canvas.editor(), &Editor::dragEnded, waiting, tryAgain, Qt::QueuedConnection);
}

} // namespace suffuse
