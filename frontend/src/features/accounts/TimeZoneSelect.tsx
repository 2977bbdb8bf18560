import { Select } from '@mantine/core'

export const ZONES = ['UTC', ...Intl.supportedValuesOf('timeZone').filter((zone) => zone !== 'UTC')]

/** A time zone, found by typing a part of its name. */
export function TimeZoneSelect({ zone, onChoose }: { zone: string; onChoose: (zone: string) => void }) {
  return (
    <Select
      label="Time zone"
      searchable
      data={ZONES.includes(zone) ? ZONES : [zone, ...ZONES]}
      value={zone}
      limit={50}
      allowDeselect={false}
      onChange={(chosen) => chosen && onChoose(chosen)}
    />
  )
}
