import type { Company, CompanyStart } from './playerState'

/** What sounds beside the source, on a bus of its own. */
export class BackingTracks {
  #company: { sounds: Company; bus: GainNode } | null = null

  has(sounds: Company | null): boolean {
    return (this.#company?.sounds ?? null) === sounds
  }

  /** Have others to sound from the next `begin` on; null for none. */
  set(sounds: Company | null, createBus: () => GainNode): void {
    this.#company = sounds && { sounds, bus: createBus() }
  }

  /** Sound from there into `to`; what sounds already goes on without a gap. */
  begin(to: AudioNode, start: Omit<CompanyStart, 'to'>): void {
    if (this.#company === null) return
    const { sounds, bus } = this.#company
    bus.connect(to)
    sounds.begin({ ...start, to: bus })
  }

  end(atS: number): void {
    this.#company?.sounds.end(atS)
  }
}
