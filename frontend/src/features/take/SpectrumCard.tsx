import { useQuery } from '@tanstack/react-query'

import { Card, CardHead } from '@/ui/Card'

import { bandsQuery, type Check } from './api'
import { BandPlot } from './BandPlot'

/** The spectrum of the whole sound, with the mark of where it ends; nothing where an earlier version drew the sound. */
export function SpectrumCard({ peaksUrl, check }: { peaksUrl: string | null; check: Check | null | undefined }) {
  const { data: bands } = useQuery(bandsQuery(peaksUrl))
  if (!bands) return null
  const bandwidth = check?.measurements.bandwidth_hz
  const rateHz = check?.facts?.sample_rate_hz
  return (
    <Card aria-labelledby="spectrum">
      <CardHead id="spectrum" title="Spectrum of the whole sound" />
      <div className="p-3-inset-14px">
        <BandPlot
          bands={bands}
          toHz={typeof rateHz === 'number' ? rateHz / 2 : (bands.hz.at(-1) ?? 20_000)}
          bandwidthHz={typeof bandwidth === 'number' ? bandwidth : null}
        />
      </div>
    </Card>
  )
}
