/** What sounds pass through on their way to the listener: the gain that fades it, and the nodes before it. */
export interface Output {
  input: AudioNode
  /** The last one; 0 is silence. */
  gain: GainNode
  /** Something begins to sound, or ends: at once, or because it is over. */
  onSounding?: (change: 'begins' | 'pauses' | 'is over') => void
  /** Take the nodes out of the graph. */
  remove: () => void
}

export type MakeOutput = (context: BaseAudioContext) => Output

/** Nothing but a gain of exactly 1: what comes out is what went in, bit for bit. */
export const direct: MakeOutput = (context) => {
  const gain = context.createGain()
  gain.connect(context.destination)
  return { input: gain, gain, remove: () => gain.disconnect() }
}
