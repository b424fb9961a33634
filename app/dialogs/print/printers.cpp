#include "app/dialogs/print/printers.h"

#include "app/dialogs/print/print_job.h"

#include <QPrinter>
#include <QPrinterInfo>

#include <algorithm>

namespace suffuse::printers {

std::vector<KnownPrinter> all()
{
    std::vector<KnownPrinter> known;
    const QString usual = QPrinterInfo::defaultPrinterName();
    for (const QString &name : QPrinterInfo::availablePrinterNames()) {
        const QPrinterInfo info = QPrinterInfo::printerInfo(name);
        const QList<int> resolutions = info.supportedResolutions();
        const int finest = resolutions.isEmpty() ? usualDpi : *std::ranges::max_element(resolutions);
        const QString title = info.description().isEmpty() ? name : info.description();
        known.insert(name == usual ? known.begin() : known.end(),
                     {name, title, std::clamp(finest, PrintSetup::leastDpi, PrintSetup::mostDpi)});
    }
    return known;
}

std::shared_ptr<QPagedPaintDevice> ready(const QString &name, const PrintTarget &target, int copies)
{
    auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setPrinterName(name);
    if (!printer->isValid())
        return nullptr;
    printer->setDocName(target.title);
    printer->setPageLayout(target.layout);
    printer->setFullPage(true);
    printer->setResolution(int(target.dpi));
    printer->setCopyCount(copies);
    return printer;
}

} // namespace suffuse::printers
