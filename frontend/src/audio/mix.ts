import { direct, type MakeOutput, type Output } from './output'
import { ramp } from './voice'

/** One way of hearing fades into another: long enough that the filters of the new one have settled. */
const CROSSFADE_S = 0.02
/** What was faded out is taken away so much later; nobody hears when. */
const REMOVE_AFTER_MS = 250

/** The bus on which all that sounds comes together, its gain, and the output behind it. */
export class Mix {
  #makeOutput: MakeOutput = direct
  #output: Output | null = null
  #bus: GainNode | null = null
  #gain = 1

  /** What a sound is connected to. */
  input(context: BaseAudioContext): GainNode {
    if (this.#bus === null) {
      this.#output = this.#makeOutput(context)
      this.#bus = context.createGain()
      this.#bus.gain.value = this.#gain
      this.#bus.connect(this.#output.input)
    }
    return this.#bus
  }

  setGain(context: BaseAudioContext | null, gainDb: number): void {
    this.#gain = 10 ** (gainDb / 20)
    if (context && this.#bus) ramp(this.#bus, { to: this.#gain, atS: context.currentTime })
  }

  /** Let an output with a tail know that something begins to sound or ends. */
  announce(change: 'begins' | 'pauses' | 'is over'): void {
    this.#output?.onSounding?.(change)
  }

  /** Pass everything through another output; what sounds is faded over to it. */
  setOutput(context: BaseAudioContext | null, makeOutput: MakeOutput, isSounding: boolean): void {
    if (makeOutput === this.#makeOutput) return
    this.#makeOutput = makeOutput
    const before = this.#output
    if (before === null || context === null) return
    const after = makeOutput(context)
    this.#output = after
    const bus = this.input(context)
    bus.connect(after.input)
    const removeBefore = () => {
      bus.disconnect(before.input)
      before.remove()
    }
    if (!isSounding) {
      removeBefore()
      return
    }
    after.gain.gain.setValueAtTime(0, context.currentTime)
    after.gain.gain.linearRampToValueAtTime(1, context.currentTime + CROSSFADE_S)
    ramp(before.gain, { to: 0, atS: context.currentTime, fadeS: CROSSFADE_S })
    after.onSounding?.('begins')
    setTimeout(removeBefore, REMOVE_AFTER_MS)
  }

  /** Forget the nodes of a context that was closed. */
  clear(): void {
    this.#output = null
    this.#bus = null
  }
}
